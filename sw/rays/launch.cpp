#include "sw/rays/launch.h"

#include <algorithm>

namespace rc2::rays {
namespace {

struct Climb {
  std::int64_t exit, slope;
};

Climb climb(const Ray& ray, int axis, int n) {
  const int fraction = slope_fraction(n);
  const std::int64_t limit = std::int64_t{steepest(n)} << fraction;
  const std::int64_t run = std::abs(ray.direction[axis]), rise = std::abs(ray.direction.z);
  std::int64_t slope = limit, first = limit;
  if (run > 0) {
    const std::int64_t steepness = (rise << fraction) / run;
    const std::int64_t way = exit_distance(ray, axis, voxel_of(ray.origin[axis]));
    slope = std::min(limit, steepness);
    first = std::min(limit, way * steepness >> kPlaceFraction);
  }
  const std::int64_t height = std::int64_t{ray.origin.z} * (1 << (fraction - kPlaceFraction));
  return ray.direction.z < 0 ? Climb{height - first, -slope} : Climb{height + first, slope};
}

}  // namespace

Launch launch(const Ray& ray, int n) {
  const std::int64_t dx = std::abs(ray.direction.x), dy = std::abs(ray.direction.y);
  const Climb x = climb(ray, 0, n), y = climb(ray, 1, n);
  return {dy * exit_distance(ray, 0, voxel_of(ray.origin.x)) -
              dx * exit_distance(ray, 1, voxel_of(ray.origin.y)),
          x.exit, y.exit, x.slope, y.slope};
}

}  // namespace rc2::rays
