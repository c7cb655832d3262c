#pragma once

#include "sw/facet/shells.h"

namespace rc2::facet {

/// A closed shell that is there several times in the same place is one shell with as many of each
/// polygon, and its parity need not be odd: of each piece one is kept, the first. Does nothing
/// unless all pieces are there equally often.
void drop_copies(const Traced& traced, Pieces& shell);

}  // namespace rc2::facet
