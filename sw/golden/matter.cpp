#include "sw/golden/matter.h"

namespace rc2::golden {
namespace {

Matter accurate_matter(const VoxelRecord& voxel, const Layers& layers, bool blocking) {
  if (!layers.is_thin(voxel.at)) return blocking ? Matter::stop : Matter::pass;
  const bool is_behind = voxel.owner.gap < 0;
  return is_behind == blocking ? Matter::front : Matter::back;
}

std::vector<glm::ivec3> ways_to_light(const std::vector<bool>& blocking, const Layers& layers) {
  std::vector<glm::ivec3> ways;
  ways.reserve(blocking.size());
  for (std::uint32_t facet = 0; facet < blocking.size(); ++facet) {
    const int code = layers.facing(facet);
    const glm::ivec3 outwards = glm::ivec3(code / 9, code / 3 % 3, code % 3) - 1;
    ways.push_back(blocking[facet] ? -outwards : outwards);
  }
  return ways;
}

}  // namespace

Field look_from(const LightJob& job, const Grid& grid, const VoxelMemory& voxels,
                const Layers& layers) {
  const bool accurate = job.rule == LightRule::accurate;
  Field field{std::vector<Matter>(grid.size(), Matter::outside), {}};
  if (accurate) field.to_light = ways_to_light(*job.blocking, layers);
  for (glm::ivec3 at{0}; at.z < grid.n(); ++at.z) {
    for (at.y = 0; at.y < grid.n(); ++at.y) {
      for (at.x = 0; at.x < grid.n(); ++at.x) {
        const std::ptrdiff_t place = grid.index(at);
        Matter& here = field.matter[static_cast<std::size_t>(place)];
        if (grid[place] == Grid::kFree) {
          here = accurate && layers.is_inside(at) ? Matter::solid : Matter::free;
        } else if (accurate) {
          const VoxelRecord& voxel = voxels[grid[place]];
          here = accurate_matter(voxel, layers, job.blocking->at(voxel.owner.facet));
        } else {
          here = Matter::stop;
        }
      }
    }
  }
  return field;
}

}  // namespace rc2::golden
