// Which polygons hang together, and which of those close.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sw/facet/traced.h"

namespace rc2::facet {

/// Pieces of a Traced, by their index.
using Pieces = std::vector<std::uint32_t>;

struct OpenShell {
  Pieces pieces;
  /// Sides, from corner to corner as their polygon goes, once for each use in one direction that no
  /// use in the other makes up for.
  std::vector<std::pair<Vertex, Vertex>> rim;
};

struct Shells {
  std::vector<Pieces> closed;
  std::vector<OpenShell> open;
};

/// Joins polygons that share a side, its ends being rounded vertices. A shell is closed if every
/// side is used as often in one direction as in the other. What closes without the sides that more
/// than two polygons share is a shell of its own: bodies that touch along an edge stay apart, and
/// may overlap elsewhere. Of a closed shell that is there several times one is left.
Shells find_shells(const Traced& traced);

}  // namespace rc2::facet
