// Where lights stand when their cycles are counted.
#pragma once

#include <string>
#include <vector>

#include "sw/machine/machine.h"

namespace rc2 {

struct LightSource {
  const char* name;
  glm::ivec3 voxel;
};

/// The free voxels nearest to the centre of the n-cube, to a place aside, where no two faces are
/// equally far away, and to a corner. Throws Error if there is none.
std::vector<LightSource> choose_sources(const std::string& scene, const VoxelMemory& voxels, int n);

}  // namespace rc2
