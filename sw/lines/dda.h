#pragma once

#include <cstdint>
#include <glm/ext/vector_int3_sized.hpp>

#include "sw/lines/segment.h"

namespace rc2::lines {

/// The digital differential analyser in space (thesis 2.3.2): a fraction is added to each
/// coordinate, and the sum is rounded to the nearest integer, ties downwards. The same voxels as
/// bresenham(), hence 26-connected, within half a voxel, and the same from either end.
///
/// The fractions have 32 bits and are rounded down, so a sum of N of them is too small by less than
/// N/2^32, and rounding ties downwards forgives that: a sum that is not a tie is at least 1/(2N)
/// away from one, which is more as long as N < 46341. With floating-point fractions, a tie goes
/// where the errors push it.
template <class Visit>
void dda(glm::ivec3 from, glm::ivec3 to, Visit&& visit) {
  constexpr int kBits = 32;
  constexpr std::int64_t kOne = std::int64_t{1} << kBits;
  const int steps = steps_between(from, to);
  visit(from);
  if (steps == 0) return;

  glm::i64vec3 fraction;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t way = kOne * (to[axis] - from[axis]);
    fraction[axis] = way / steps - static_cast<std::int64_t>(way % steps < 0);
  }
  // Dropping the bits of the fraction rounds down; this much more, to the nearest.
  glm::i64vec3 at = glm::i64vec3(from) * kOne + (kOne / 2 - 1);
  for (int step = 0; step < steps; ++step) {
    at += fraction;
    visit(glm::ivec3(at >> glm::i64vec3(kBits)));
  }
}

}  // namespace rc2::lines
