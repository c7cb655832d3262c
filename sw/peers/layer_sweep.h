// Light as a sweep over the layers of six pyramids: the array's digital rays, in software.
#pragma once

#include "sw/peers/bit_grid.h"

namespace rc2::peers {

/// Voxels that light reaches. In each pyramid layer k is decided from layer k-1: a voxel is reached
/// if its parent is and does not stop light; the parent is the voxel of layer k-1 nearest to the
/// straight way to the light. One look at every voxel, whatever the scene. The parents of parents
/// are not on the straight way any more: each is rounded anew, which bends the ways by up to half
/// a voxel a step, and no choice of L makes them finer.
BitGrid sweep_layers(const BitGrid& stops, const glm::ivec3& light);

}  // namespace rc2::peers
