#include "sw/peers/grid_walk.h"

#include "sw/lines/amanatides_woo.h"

namespace rc2::peers {

std::vector<bool> walk_to_light(const BitGrid& stops, const std::vector<glm::ivec3>& voxels,
                                const glm::ivec3& light, int leave) {
  std::vector<bool> lit;
  lit.reserve(voxels.size());
  for (const glm::ivec3& voxel : voxels) {
    int steps = 0;
    bool is_free = true;
    lines::amanatides_woo(voxel, light, [&](const glm::ivec3& at) {
      is_free = steps++ <= leave || at == light || !stops.at(at);
      return is_free;
    });
    lit.push_back(is_free);
  }
  return lit;
}

}  // namespace rc2::peers
