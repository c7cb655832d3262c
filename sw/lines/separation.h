#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sw/lines/neighbourhood.h"

namespace rc2::lines {

/// A shortest ray, connected as `rays`, that enters a window of `size` voxels (0 <= voxel < size)
/// at its highest z and leaves it at z = 0 through voxels for which is_free(voxel); empty if there
/// is none, which means that the other voxels separate the top of the window from its bottom.
template <class IsFree>
std::vector<glm::ivec3> find_ray(glm::ivec3 size, Adjacency rays, const IsFree& is_free) {
  const auto index = [&](glm::ivec3 at) {
    return static_cast<std::size_t>((std::ptrdiff_t{at.z} * size.y + at.y) * size.x + at.x);
  };
  constexpr int kUnseen = -2, kEntry = -1;
  std::vector<int> before(index({0, 0, size.z}), kUnseen);
  std::vector<glm::ivec3> seen;  // in the order of their distance
  const auto see = [&](glm::ivec3 at, int from) {
    if (before[index(at)] != kUnseen || !is_free(at)) return;
    before[index(at)] = from;
    seen.push_back(at);
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) see({x, y, size.z - 1}, kEntry);

  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].z == 0) {
      std::vector<glm::ivec3> ray;
      for (int at = static_cast<int>(i); at != kEntry;
           at = before[index(seen[static_cast<std::size_t>(at)])])
        ray.push_back(seen[static_cast<std::size_t>(at)]);
      std::reverse(ray.begin(), ray.end());
      return ray;
    }
    for (std::size_t s = 0; s < static_cast<std::size_t>(rays); ++s) {
      const glm::ivec3 at = seen[i] + kSteps[s];
      if (at.x >= 0 && at.x < size.x && at.y >= 0 && at.y < size.y && at.z >= 0 && at.z < size.z)
        see(at, static_cast<int>(i));
    }
  }
  return {};
}

}  // namespace rc2::lines
