// Rays for the tests: of all directions, and of those that are awkward.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "sw/machine/machine.h"
#include "sw/machine/ray_job.h"
#include "sw/rays/ray.h"
#include "sw/scene/random.h"

namespace rc2 {

/// How many rounds of random rays a test makes: RC2_RAY_ROUNDS, or as many as it can spare.
inline std::uint64_t ray_rounds(std::uint64_t usual) {
  const char* asked = std::getenv("RC2_RAY_ROUNDS");
  return asked == nullptr ? usual : std::strtoull(asked, nullptr, 10);
}

/// A unit vector of direction_fraction(n) bits. One in three has components that are 0 or equal:
/// along an axis, through edges or corners. One in ten grazes the sides of
/// voxels.
inline glm::ivec3 random_direction(scene::Random& random, int n) {
  for (;;) {
    glm::dvec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (random.below(3) == 0) v = glm::sign(v) * static_cast<double>(random.below(2));
    for (int axis = 0; axis < 3; ++axis)
      if (random.below(5) == 0) v[axis] = 0;
    if (random.below(10) == 0)
      v[random.below(3)] = (random.below(3) - 1) * std::exp2(-rays::direction_fraction(n));
    const double length = glm::length(v);
    if (length < 0.1) continue;
    const glm::ivec3 rounded(glm::floor(v / length * std::exp2(rays::direction_fraction(n)) + 0.5));
    return rounded;
  }
}

/// From anywhere in the cube; one in three from a corner, side or middle of a voxel.
inline rays::Ray random_ray(scene::Random& random, int n) {
  rays::Ray ray;
  ray.home = {0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = random.below(rays::kPlaceOne * n) - rays::kPlaceOne / 2;
    if (random.below(3) == 0) ray.origin[axis] &= ~(rays::kPlaceOne / 2 - 1);
  }
  ray.direction = random_direction(random, n);
  return ray;
}

/// One for each pixel of n x n; if there are voxels, half of them start in one of these, which a
/// facet owns.
inline std::vector<RayStart> random_starts(std::uint64_t seed, int n,
                                           const VoxelMemory& voxels = {}) {
  scene::Random random(seed);
  std::vector<RayStart> starts;
  for (int i = 0; i < n * n; ++i) {
    rays::Ray ray = random_ray(random, n);
    if (!voxels.empty() && random.below(2) == 0) {
      const auto which = static_cast<std::size_t>(random.below(static_cast<int>(voxels.size())));
      const glm::ivec3 part = ray.origin - rays::kPlaceOne * rays::voxel_of(ray.origin);
      ray.origin = rays::kPlaceOne * voxels[which].at + part;
    }
    starts.push_back({ray.origin, ray.direction});
  }
  return starts;
}

}  // namespace rc2
