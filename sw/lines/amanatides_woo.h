#pragma once

#include <cstdint>
#include <glm/ext/vector_int3_sized.hpp>
#include <limits>
#include <type_traits>

#include "sw/lines/segment.h"

namespace rc2::lines {

/// The line of Amanatides and Woo (thesis 2.3.5): every voxel that the segment passes through,
/// face after face. 6-connected; the segment meets every voxel, so no coordinate is off by more
/// than half a voxel at the nearest point of the segment; the same voxels from either end.
///
/// The parameters of the crossings are fractions; multiplied by their common denominator they are
/// integers and the choice is exact. Where the segment meets an edge or a corner, a point between
/// two voxels belongs to the lower one, as if the segment were moved by -(e, e^2, e^3) for a tiny
/// e: axes that decrease step first, in the order x, y, z, then those that increase, z, y, x. The
/// printed order (z before y before x) depends on the end one starts from.
/// A visit that returns a bool ends the walk with false.
/// As printed, an axis without a step gets Tmax = 1 and the loop never ends; here it is never next.
template <class Visit>
void amanatides_woo(glm::ivec3 from, glm::ivec3 to, Visit&& visit) {
  // Times are multiples of this, which leaves room for the rank that decides between equal ones.
  constexpr std::int64_t kRanks = 8;
  const glm::ivec3 way = to - from, sign = glm::sign(way);
  const glm::i64vec3 length = glm::max(glm::i64vec3(glm::abs(way)), std::int64_t{1});
  const glm::i64vec3 half = kRanks * (length.x * length.y * length.z / length);
  glm::i64vec3 next;  // the time at which each axis crosses its next face
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0) {
      next[axis] = std::numeric_limits<std::int64_t>::max();
    } else {
      next[axis] = half[axis] + (way[axis] < 0 ? axis : 5 - axis);
    }
  }
  const auto goes_on = [&] {
    if constexpr (std::is_void_v<decltype(visit(from))>) {
      visit(from);
      return true;
    } else {
      return visit(from);
    }
  };
  if (!goes_on()) return;
  const glm::ivec3 crossings = glm::abs(way);
  for (int step = crossings.x + crossings.y + crossings.z; step > 0; --step) {
    const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
    next[axis] += 2 * half[axis];
    from[axis] += sign[axis];
    if (!goes_on()) return;
  }
}

}  // namespace rc2::lines
