// The way of a ray through the voxels, without steps: every side that it crosses is worked out from
// the ray's start.
#pragma once

#include <algorithm>

#include "sw/rays/launch.h"

namespace rc2::golden {

/// Calls visit(voxel, axis) of every voxel of the n-cube on the ray's way, in order, `axis` being
/// that of the side through which the ray leaves it, until visit returns true. The j-th side in x
/// comes before the k-th in y if |dy| times the way to it in x is less than |dx| times the way in
/// y: exact. In a column the ray is in the voxels between the heights at which it comes and goes.
template <typename Visit>
void walk(const rays::Ray& ray, int n, Visit visit) {
  const rays::Launch start = rays::launch(ray, n);
  const std::int64_t dx = std::abs(ray.direction.x), dy = std::abs(ray.direction.y);
  const int fraction = rays::slope_fraction(n), up = ray.direction.z < 0 ? -1 : 1;
  const auto is_outside = [n](int coordinate) { return coordinate < 0 || coordinate >= n; };
  std::int64_t steps_x = 0, steps_y = 0;
  glm::ivec3 at = rays::voxel_of(ray.origin);
  for (;;) {
    const bool along_x =
        dy * rays::exit_distance(ray, 0, at.x) < dx * rays::exit_distance(ray, 1, at.y);
    const std::int64_t exit =
        along_x ? start.exit_x + steps_x * start.slope_x : start.exit_y + steps_y * start.slope_y;
    const auto exit_z = static_cast<int>((exit + (std::int64_t{1} << (fraction - 1))) >> fraction);
    const int axis = along_x ? 0 : 1, last = up * std::max(up * at.z, up * exit_z);
    for (;; at.z += up) {
      if (is_outside(at.z)) return;
      if (visit(at, at.z == last ? axis : 2)) return;
      if (at.z == last) break;
    }
    ++(along_x ? steps_x : steps_y);
    at[axis] += ray.direction[axis] < 0 ? -1 : 1;
    if (is_outside(at[axis])) return;
  }
}

}  // namespace rc2::golden
