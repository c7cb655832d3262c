#pragma once

#include "sw/lines/segment.h"

namespace rc2::lines {
namespace detail {

// Visits the voxels strictly between a and b, which are `steps` apart.
template <class Visit>
void halve(glm::ivec3 a, glm::ivec3 b, int steps, bool towards_a, Visit& visit) {
  if (steps <= 1) return;
  const glm::ivec3 half = (b - a) / 2;  // rounded towards zero
  const glm::ivec3 middle = towards_a ? a + half : b - half;
  const int before = towards_a ? steps / 2 : steps - steps / 2;
  halve(a, middle, before, towards_a, visit);
  visit(middle);
  halve(middle, b, steps - before, towards_a, visit);
}

}  // namespace detail

/// The dichotomic line (thesis 2.3.3): the voxel in the middle, then both halves likewise, until
/// the ends are neighbours. In integers, 26-connected, one voxel per step along the longest axis.
/// Errors of rounding add up over the halvings: N steps put a voxel off the segment by as much as
/// (2 ceil(log2 N) + 1)/6 along each of the other two axes.
///
/// A middle between two voxels is rounded, in all coordinates, towards the end of the segment that
/// comes first in the order of x, then y, then z: the same voxels from either end. Rounding each
/// coordinate by itself, as printed, bends diagonals: (0,3)-(3,0) would get five voxels.
/// As printed, the recursion never ends on two neighbours and both ends of the segment are missing.
template <class Visit>
void dichotomic(glm::ivec3 from, glm::ivec3 to, Visit&& visit) {
  visit(from);
  if (from == to) return;
  const glm::ivec3 way = to - from;
  const int first = way.x != 0 ? way.x : (way.y != 0 ? way.y : way.z);
  detail::halve(from, to, steps_between(from, to), first > 0, visit);
  visit(to);
}

}  // namespace rc2::lines
