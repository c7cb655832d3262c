// How long each stage of a cell is at work on a ray (rtl/rays/rc2_ray_launch.sv, rc2_ray_meet.sv,
// rc2_ray_snell.sv, rc2_ray_bend.sv).
#pragma once

#include <algorithm>

#include "sw/rays/format.h"

namespace rc2::cycle::ray_timing {

/// Cycles of a division or a root of so many bits, `step` of them in each.
constexpr int steps(int bits, int step) { return (bits + step - 1) / step; }

/// Bits of the quotients and of the root, and how many come in a cycle (rtl/rc2_pkg.sv).
constexpr int slope_quotient_bits(int n) {
  return rays::slope_fraction(n) + coordinate_bits(n) + 8;
}
constexpr int bend_quotient_bits(int n) { return rays::direction_fraction(n) + 5; }
constexpr int root_bits(int n) { return rays::direction_fraction(n) + 11; }
constexpr int kSlopeStep = 4, kMeetStep = 2, kBendStep = 2, kRootStep = 2;

/// From the cycle in which a stage takes a ray up to that in which the next one may: a ray begins,
constexpr int launch(int n) { return steps(slope_quotient_bits(n), kSlopeStep) + 3; }
/// meets a plane and finds, if it is glass, how much it turns there,
constexpr int meet(int n, bool is_refracted) {
  const int point = steps(rays::meeting_bits(n), kMeetStep) + 4;
  return is_refracted ? std::max(point, steps(root_bits(n), kRootStep) + 7) : point;
}
/// and new directions come of it.
constexpr int bend(int n) { return steps(bend_quotient_bits(n), kBendStep) + 4; }
/// A stage in which there is nothing to do.
constexpr int kNothing = 1;

/// From the cycle in which a ray is looked at to the verdict on the last of the voxels that are
/// read: a cycle for each, planes, verdict.
constexpr int read(int voxels) { return voxels + 1; }

/// From the cycle in which a hit is to be answered: each of the new rays begins, the answer leaves.
constexpr int kMirrored = 1, kCleared = 2, kAnswer = 3;

}  // namespace rc2::cycle::ray_timing
