// What a ray is given for its way when it starts: the numbers that the cells step by additions.
#pragma once

#include <cstdint>

#include "sw/rays/ray.h"

namespace rc2::rays {

/// A ray goes from cell to cell through their sides, never across a corner, so that 6-separating
/// armour stops it. In each cell it is in the voxels between the height at which it came in and
/// that at which it leaves, both rounded.
struct Launch {
  /// |dy| times the way in x to the side of the first cell, less |dx| times that in y. Negative:
  /// the ray leaves through the side in x. An axis of direction 0 is never chosen.
  std::int64_t decision;
  /// Height (z) where the ray meets the next side in x, in y, slope_fraction(n) fraction bits; and
  /// what comes to it from one such side to the next, cut off towards 0. Where there is no such
  /// side, beyond the cube.
  std::int64_t exit_x, exit_y, slope_x, slope_y;
};

/// Two divisions.
Launch launch(const Ray& ray, int n);

}  // namespace rc2::rays
