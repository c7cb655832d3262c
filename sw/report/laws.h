// What holds for every machine in every run, whatever the scene. A machine that breaks a law is
// wrong by itself, without a comparison, so std::logic_error is thrown, not Error.
#pragma once

#include "sw/machine/machine.h"

namespace rc2::report {

/// Voxels lie in the n-cube, strictly in the order of z, y, x, and belong to facets 0 .. facets-1.
void check_voxels(const VoxelMemory& voxels, int n, std::size_t facets);

/// Conservation: absorbed + escaped + skipped = total = 24 L^2 + 2 targets, and by the thesis's
/// rule, which lights no voxel but where a target ends, the counts of the voxels add up to
/// absorbed. `voxels` is the number of occupied voxels.
void check_light(const LightResult& result, const LightMemory& counts, const LightJob& job,
                 std::size_t voxels);

/// Conservation: every ray issued has hit a facet or left the cube, and is among the hits once; a
/// child is as deep as it says and worth no more than its parent, two together likewise.
void check_rays(const RayResult& result);

}  // namespace rc2::report
