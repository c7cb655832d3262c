#pragma once

#include "sw/golden/grid.h"
#include "sw/golden/matter.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

struct Diffusion {
  TargetCount targets;
  std::int64_t visits = 0;  ///< voxels examined
};

/// Sends one digital ray from the source to every target of the six faces at `distance`, and on
/// beyond it, until a voxel ends the ray or it leaves the cube (thesis 4.3). `grid` holds the
/// numbers of the occupied voxels, `field` is what the voxels are to this light, by their places in
/// the grid; arrived[number] counts the rays that come there.
Diffusion diffuse(const Grid& grid, const std::vector<Matter>& field, glm::ivec3 source,
                  int distance, LightMemory& arrived, const Progress& progress);

}  // namespace rc2::golden
