// Closed convex bodies, exactly.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "tb/stress/attacks.h"

namespace rc2::stress {

/// Whether the voxel's centre p is in any of the bodies. On the border p stands for
/// p + (e, e^2, e^3), e -> 0+.
bool is_in_a_body(const std::vector<Body>& bodies, const Cube& cube, const glm::ivec3& voxel);

/// Whether two bodies that are not the same share a facet.
bool share_a_facet(const std::vector<Body>& bodies);

}  // namespace rc2::stress
