// Solids: closed shells with the cavities in them.
#pragma once

#include "sw/facet/shells.h"

namespace rc2::facet {

struct Objects {
  std::vector<Pieces> solids;  ///< inside: what an odd number of the solid's shells encloses
  std::int64_t rooms = 0;      ///< shells that are rooms, counted
};

/// Puts together the closed shells whose parities count as one. A shell within another that faces
/// the opposite way is a cavity of it, or what fills a cavity starts anew. A shell that faces
/// inwards, is in no other and has a shell that faces outwards in it is a room: it encloses air,
/// not matter, and is no part of any solid. Other shells that face inwards are taken for bodies
/// turned inside out. Of shells that cross, one counts as in the other if its box and its least
/// corner (by x, then y, then z) are.
Objects find_objects(const Traced& traced, const std::vector<Pieces>& closed);

}  // namespace rc2::facet
