#include "sw/machine/find_voxel.h"

#include <algorithm>
#include <tuple>

namespace rc2 {

const VoxelRecord* find_voxel(const VoxelMemory& voxels, glm::ivec3 at) {
  const auto found = std::lower_bound(voxels.begin(), voxels.end(), at,
                                      [](const VoxelRecord& voxel, glm::ivec3 wanted) {
                                        return std::tie(voxel.at.z, voxel.at.y, voxel.at.x) <
                                               std::tie(wanted.z, wanted.y, wanted.x);
                                      });
  return found != voxels.end() && found->at == at ? &*found : nullptr;
}

}  // namespace rc2
