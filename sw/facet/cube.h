#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace rc2::facet {

/// Whether any point of the polygon lies in the cube [-1/2, n-1/2]^3. May say yes for a concave
/// polygon that goes round a corner of the cube.
bool reaches_cube(std::vector<glm::dvec3> corners, int n);

}  // namespace rc2::facet
