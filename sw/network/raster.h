// The pixels that the networks must light.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace rc2::network {

/// The first octant (0 <= y <= x) of the circle about the origin, from (R, 0) upwards: in row y the
/// integer x nearest to sqrt(R^2 - y^2), which is never a tie. Midpoint rule, integers only.
std::vector<glm::ivec2> circle_arc(int radius);

/// The pixels (0, 0) .. (n, height), one a column, 0 <= height <= n: the integer y nearest to
/// height * x / n, ties downwards, which is Bresenham's line as in sw/lines. (Ties upwards, as
/// thesis 2.3.1 prints it, are the same lines seen in the mirror y -> x - y.)
std::vector<glm::ivec2> segment(int n, int height);

}  // namespace rc2::network
