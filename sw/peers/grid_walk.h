// A walk through the voxels from each place to the light, as one would write it in software.
#pragma once

#include <vector>

#include "sw/peers/bit_grid.h"

namespace rc2::peers {

/// Amanatides and Woo's line (sw/lines) from each voxel to the light's: lit if it meets no voxel of
/// `stops` on its way, the two ends aside. `leave`: what it meets in so many first voxels counts
/// for its own surface, which is thicker than a voxel, and does not stop it.
std::vector<bool> walk_to_light(const BitGrid& stops, const std::vector<glm::ivec3>& voxels,
                                const glm::ivec3& light, int leave);

}  // namespace rc2::peers
