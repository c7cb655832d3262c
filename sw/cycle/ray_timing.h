// How long a cell is at work on a ray (rtl/rays/rc2_ray_engine.sv, rc2_ray_unit.sv).
#pragma once

#include "sw/rays/format.h"

namespace rc2::cycle::ray_timing {

/// Bits of the quotients and of the root, each of which takes a cycle (rtl/rc2_pkg.sv).
constexpr int slope_quotient_bits(int n) {
  return rays::slope_fraction(n) + coordinate_bits(n) + 8;
}
constexpr int bend_quotient_bits(int n) { return rays::direction_fraction(n) + 5; }
constexpr int root_bits(int n) { return rays::direction_fraction(n) + 11; }

/// Each operation with the cycle in which it is asked for; a division or a root takes one to begin.
constexpr int launch(int n) { return 1 + 2 * (1 + slope_quotient_bits(n)) + 4; }
constexpr int meet(int n) { return 1 + (1 + rays::meeting_bits(n)) + 3; }
constexpr int reflect(int n) { return 1 + 3 + (1 + bend_quotient_bits(n)) + 3; }
constexpr int refract(int n, bool all_is_reflected) {
  return all_is_reflected ? 1 + 6
                          : 1 + 3 + 3 + (1 + root_bits(n)) + 4 + (1 + bend_quotient_bits(n)) + 3;
}

/// From the cycle in which a ray that begins is taken up to that in which its column is looked
/// into: its launch, one to take over what came of it.
constexpr int begin(int n) { return launch(n) + 2; }

/// From there to the verdict on the last of the voxels that are read: address, planes, verdict.
constexpr int read(int voxels) { return voxels + 2; }

/// Before the answer to a hit: sharing out the weights, a cycle for each new ray.
constexpr int kShare = 1, kChild = 1;

}  // namespace rc2::cycle::ray_timing
