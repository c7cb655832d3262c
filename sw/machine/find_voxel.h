#pragma once

#include "sw/machine/machine.h"

namespace rc2 {

/// The record of an occupied voxel, or null.
const VoxelRecord* find_voxel(const VoxelMemory& voxels, glm::ivec3 at);

}  // namespace rc2
