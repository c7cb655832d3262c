#include "sw/report/laws.h"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>
#include <tuple>

namespace rc2::report {
namespace {

std::string place(glm::ivec3 at) { return fmt::format("({},{},{})", at.x, at.y, at.z); }

}  // namespace

void check_voxels(const VoxelMemory& voxels, int n, std::size_t facets) {
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const glm::ivec3 at = voxels[i].at;
    for (int axis = 0; axis < 3; ++axis) {
      if (at[axis] < 0 || at[axis] >= n) {
        throw std::logic_error(
            fmt::format("the machine names voxel {} of a cube of side {}", place(at), n));
      }
    }
    if (voxels[i].owner.facet >= facets) {
      throw std::logic_error(
          fmt::format("the machine gives voxel {} to facet {}, but only {} were "
                      "loaded",
                      place(at), voxels[i].owner.facet, facets));
    }
    if (i == 0) continue;
    const glm::ivec3 before = voxels[i - 1].at;
    if (std::tie(before.z, before.y, before.x) >= std::tie(at.z, at.y, at.x)) {
      throw std::logic_error(fmt::format("the machine reads voxel {} after {}: out of order",
                                         place(at), place(before)));
    }
  }
}

void check_light(const LightResult& result, const LightMemory& counts, const LightJob& job,
                 std::size_t voxels) {
  const TargetCount& targets = result.targets;
  const std::int64_t sent = total_targets(job.target_distance);
  if (targets.total != sent ||
      targets.absorbed + targets.escaped + targets.skipped != targets.total) {
    throw std::logic_error(
        fmt::format("conservation is broken for the light at {}: {} absorbed + {} escaped + {} "
                    "skipped of {} targets, where {} were sent",
                    place(job.source), targets.absorbed, targets.escaped, targets.skipped,
                    targets.total, sent));
  }
  if (counts.size() != voxels) {
    throw std::logic_error(
        fmt::format("the machine reads {} counts of light for {} voxels", counts.size(), voxels));
  }
  if (job.rule != LightRule::thesis) return;
  const std::int64_t counted = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  if (counted != targets.absorbed) {
    throw std::logic_error(
        fmt::format("conservation is broken for the light at {}: the voxels count {} targets, but "
                    "{} were absorbed",
                    place(job.source), counted, targets.absorbed));
  }
}

}  // namespace rc2::report
