#include "sw/report/laws.h"

#include <fmt/format.h>

#include <map>
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

void check_rays(const RayResult& result) {
  const RayCounts& counts = result.counts;
  const auto ended = static_cast<std::int64_t>(result.hits.size());
  if (counts.total() != counts.hits + counts.escaped || counts.total() != ended) {
    throw std::logic_error(
        fmt::format("rays are lost: {} issued, {} have hit, {} have escaped, {} came home",
                    counts.total(), counts.hits, counts.escaped, ended));
  }
  std::array<std::int64_t, rays::kMaxDepth + 1> seen{};
  std::map<std::tuple<int, int, int>, int> left;  // of the weight, by pixel and node
  for (const RayHit& hit : result.hits) {
    const rays::Ray& ray = hit.ray;
    const auto [at, is_new] =
        left.emplace(std::tuple(ray.home.x, ray.home.y, ray.node), ray.weight);
    const auto parent = left.find({ray.home.x, ray.home.y, ray.node / 2});
    const bool is_first = ray.node == 1;
    if (!is_new || (!is_first && (parent == left.end() || (parent->second -= ray.weight) < 0))) {
      throw std::logic_error(
          fmt::format("node {} of pixel ({}, {}) is there twice, has no parent or is worth more "
                      "than what is left of its parent's weight",
                      ray.node, ray.home.x, ray.home.y));
    }
    ++seen[static_cast<std::size_t>(rays::depth_of(ray.node))];
  }
  if (seen != counts.issued) throw std::logic_error("rays came home that were not issued");
}

}  // namespace rc2::report
