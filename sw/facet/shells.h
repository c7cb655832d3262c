// Which polygons hang together, and which of those close.
#pragma once

#include <cstdint>
#include <vector>

#include "sw/facet/traced.h"

namespace rc2::facet {

/// Pieces of a Traced, by their index.
using Pieces = std::vector<std::uint32_t>;

struct Shells {
  std::vector<Pieces> closed;
  std::int64_t open = 0;  ///< the others, counted
};

/// Joins polygons that share a side, its ends being rounded vertices. A shell is closed if every
/// side is used as often in one direction as in the other. What closes without the sides that more
/// than two polygons share is a shell of its own: bodies that touch along an edge stay apart, and
/// may overlap elsewhere.
Shells find_shells(const Traced& traced);

}  // namespace rc2::facet
