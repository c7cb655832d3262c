#include "sw/lines/connectivity.h"

#include <algorithm>
#include <vector>

namespace rc2::lines {
namespace {

bool is_one_piece(const VoxelSet& voxels, Adjacency adjacency) {
  if (voxels.empty()) return false;
  VoxelSet reached = {*voxels.begin()};
  std::vector<glm::ivec3> fresh = {*voxels.begin()};
  while (!fresh.empty()) {
    const glm::ivec3 from = fresh.back();
    fresh.pop_back();
    for (std::size_t s = 0; s < static_cast<std::size_t>(adjacency); ++s) {
      const glm::ivec3 to = from + kSteps[s];
      if (voxels.count(to) != 0 && reached.insert(to).second) fresh.push_back(to);
    }
  }
  return reached.size() == voxels.size();
}

}  // namespace

std::optional<Adjacency> connectivity(const VoxelSet& voxels) {
  for (const Adjacency adjacency : kAdjacencies)
    if (is_one_piece(voxels, adjacency)) return adjacency;
  return std::nullopt;
}

Adjacency local_connectivity(const VoxelSet& voxels) {
  Adjacency weakest = Adjacency::face;
  for (const glm::ivec3& at : voxels) {
    const Neighbourhood around =
        neighbourhood(at, [&](glm::ivec3 voxel) { return voxels.count(voxel) != 0; });
    weakest = std::max(weakest, local_connectivity(around));
  }
  return weakest;
}

}  // namespace rc2::lines
