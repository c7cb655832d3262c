#include "sim/light_sources.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/lights.h"

namespace rc2 {

std::vector<LightSource> choose_sources(const std::string& scene, const VoxelMemory& voxels,
                                        int n) {
  const auto at = [&](double share) { return static_cast<int>(std::lround(share * (n - 1))); };
  std::vector<LightSource> sources = {{"centre", glm::ivec3(n / 2)},
                                      {"aside", {at(.23), at(.67), at(.81)}},
                                      {"corner", glm::ivec3(0)}};
  for (LightSource& source : sources) {
    const auto free = nearest_free(voxels, source.voxel, n);
    if (!free) {
      throw Error(fmt::format(
          "{}: every voxel is occupied, so no light can be placed; use a larger --n", scene));
    }
    source.voxel = *free;
  }
  return sources;
}

}  // namespace rc2
