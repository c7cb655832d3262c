#pragma once

#include "sw/golden/grid.h"
#include "sw/golden/layers.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

/// Follows one ray after the other, each from its start to what it hits, and then those that come
/// of it (thesis 1.3.2). `grid` holds the number of each voxel in `voxels`.
RayResult trace(const Grid& grid, const VoxelMemory& voxels, const Layers& layers,
                const RayJob& job, const Progress& progress);

}  // namespace rc2::golden
