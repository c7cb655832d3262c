#include "sw/machine/ray_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "sw/machine/checks.h"

namespace rc2 {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw Error(fmt::format("the rays cannot be traced: {}", why));
}

void check_start(const RayStart& start, std::size_t pixel, int n) {
  if (start.direction == glm::ivec3(0)) return;
  const glm::ivec3 voxel = rays::voxel_of(start.origin);
  if (glm::clamp(voxel, 0, n - 1) != voxel)
    refuse(fmt::format("that of pixel ({}, {}) starts outside the cube; clip it to the cube",
                       pixel % static_cast<std::size_t>(n), pixel / static_cast<std::size_t>(n)));
  const double one = 1 << rays::direction_fraction(n);
  double square = 0;
  for (int axis = 0; axis < 3; ++axis)
    square += start.direction[axis] * 1.0 * start.direction[axis];
  if (square < 0.9 * one * one || square > 1.1 * one * one)
    refuse(
        fmt::format("the direction of pixel ({}, {}) is no unit vector of {} fraction bits; "
                    "normalise it",
                    pixel % static_cast<std::size_t>(n), pixel / static_cast<std::size_t>(n),
                    rays::direction_fraction(n)));
}

}  // namespace

bool operator==(const RayHit& a, const RayHit& b) {
  const auto key = [](const RayHit& hit) {
    const rays::Ray& ray = hit.ray;
    return std::tie(ray.home, ray.node, ray.inside, ray.weight, ray.origin, ray.direction,
                    hit.facet);
  };
  if (key(a) != key(b)) return false;
  return a.facet == RayHit::kNoFacet ||
         (a.is_back == b.is_back && a.voxel == b.voxel && a.point == b.point);
}

bool operator==(const RayCounts& a, const RayCounts& b) {
  const auto all = [](const RayCounts& c) {
    return std::tie(c.issued, c.hits, c.escaped, c.rescued, c.too_light, c.too_deep, c.probes,
                    c.planes);
  };
  return all(a) == all(b);
}

RayTraffic::Busiest RayTraffic::busiest() const {
  const std::array<int, kRayStages> of{units.looks, 1, units.arithmetic, units.arithmetic};
  Busiest busiest{0, kRayStageNames[0]};
  for (std::size_t stage = 0; stage < kRayStages; ++stage) {
    const std::int64_t least = (work[stage] + of[stage] - 1) / of[stage];
    if (least > busiest.cycles) busiest = {least, kRayStageNames[stage]};
  }
  return busiest;
}

std::int64_t RayCounts::total() const {
  return std::accumulate(issued.begin(), issued.end(), std::int64_t{0});
}

void sort_hits(std::vector<RayHit>& hits) {
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return std::tie(a.ray.home.y, a.ray.home.x, a.ray.node) <
           std::tie(b.ray.home.y, b.ray.home.x, b.ray.node);
  });
}

rays::Ray primary_ray(const glm::ivec2& pixel, int n) {
  rays::Ray ray;
  ray.home = pixel;
  ray.origin = rays::kPlaceOne * glm::ivec3(pixel, n - 1);
  ray.origin.z += rays::kPlaceOne / 2 - 1;
  ray.direction = {0, 0, -(1 << rays::direction_fraction(n))};
  return ray;
}

rays::Ray first_ray(const RayJob& job, const glm::ivec2& pixel, int n) {
  rays::Ray ray = primary_ray(pixel, n);
  if (job.starts == nullptr) return ray;
  const RayStart& start =
      (*job.starts)[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(n) +
                    static_cast<std::size_t>(pixel.x)];
  ray.origin = start.origin;
  ray.direction = start.direction;
  return ray;
}

void check_rays(const MachineConfig& config, const RayJob& job, const VoxelMemory& voxels) {
  if (!config.layers) refuse("this machine was built without layers; use one that has them");
  if (job.limits.depth < 0 || job.limits.depth > rays::kMaxDepth)
    refuse(fmt::format("the depth is {}; choose 0 to {}", job.limits.depth, rays::kMaxDepth));
  if (job.limits.least_weight < 0 || job.limits.least_weight > rays::kWeightOne)
    refuse(fmt::format("the least weight is {}; choose 0 to {}", job.limits.least_weight,
                       rays::kWeightOne));
  if (job.queue < 1) refuse(fmt::format("a queue has {} places; choose 1 or more", job.queue));
  const std::size_t pixels = static_cast<std::size_t>(config.n) * config.n;
  if (job.starts != nullptr && job.starts->size() != pixels)
    refuse(fmt::format("there are {} starts for {} pixels; give one for each", job.starts->size(),
                       pixels));
  for (std::size_t i = 0; job.starts != nullptr && i < pixels; ++i)
    check_start((*job.starts)[i], i, config.n);
  for (const VoxelRecord& voxel : voxels)
    if (voxel.owner.facet >= job.facets->size())
      refuse(
          fmt::format("voxel ({},{},{}) belongs to facet {}, of which the job says nothing; "
                      "make the job for the facets that were loaded",
                      voxel.at.x, voxel.at.y, voxel.at.z, voxel.owner.facet));
}

}  // namespace rc2
