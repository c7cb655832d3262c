#pragma once

#include "sw/golden/grid.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

struct Diffusion {
  TargetCount targets;
  std::int64_t visits = 0;  ///< voxels examined
};

/// Sends one digital ray from the source to every target of the six faces at `distance`, and on
/// beyond it, until the ray meets an occupied voxel or leaves the cube (thesis 4.3).
/// `grid` holds the number of each occupied voxel; arrived[number] counts the rays that end there.
Diffusion diffuse(const Grid& grid, glm::ivec3 source, int distance, LightMemory& arrived,
                  const Progress& progress);

}  // namespace rc2::golden
