// Convex polygons on the integer lattice of a plane.
#pragma once

#include <cstdint>
#include <glm/ext/vector_int2_sized.hpp>
#include <vector>

#include "tb/load/dice.h"

namespace rc2::facet {

using FlatVertex = glm::i64vec2;

/// A strictly convex polygon with the given number of sides (>= 3), or fewer where sides happen to
/// be parallel. Its sides are up to 2 * reach long along each axis, its lowest coordinates are 0.
std::vector<FlatVertex> lattice_polygon(Dice& dice, int sides, std::int64_t reach);

}  // namespace rc2::facet
