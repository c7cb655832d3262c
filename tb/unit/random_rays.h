// Rays for the tests: of all directions, and of those that are awkward.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "sw/machine/ray_job.h"
#include "sw/rays/ray.h"
#include "sw/scene/random.h"

namespace rc2 {

/// A unit vector of direction_fraction(n) bits. One in three has components that are 0 or equal.
inline glm::ivec3 random_direction(scene::Random& random, int n) {
  for (;;) {
    glm::dvec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (random.below(3) == 0) v = glm::sign(v) * static_cast<double>(random.below(2));
    for (int axis = 0; axis < 3; ++axis)
      if (random.below(5) == 0) v[axis] = 0;
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

/// One for each pixel of n x n.
inline std::vector<RayStart> random_starts(std::uint64_t seed, int n) {
  scene::Random random(seed);
  std::vector<RayStart> starts;
  for (int i = 0; i < n * n; ++i) {
    const rays::Ray ray = random_ray(random, n);
    starts.push_back({ray.origin, ray.direction});
  }
  return starts;
}

}  // namespace rc2
