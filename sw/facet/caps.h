#pragma once

#include "sw/facet/shells.h"

namespace rc2::facet {

/// Closes the small holes of nearly closed shells, so that their inside is known: over each hole
/// goes a cone of triangles from its rim to the middle of the rim's corners. Appends the triangles
/// to the pieces of `traced`, as pieces without a facet, and moves the shell to the closed ones. A
/// shell stays open if its caps have more than a tenth of its own area: it rather is a sheet or a
/// bowl. Returns how many were closed.
std::int64_t cap_holes(Traced& traced, Shells& shells);

}  // namespace rc2::facet
