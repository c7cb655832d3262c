// What the line algorithms of chapter 2 have in common.
//
// Each is a function template (from, to, visit) that calls visit(voxel) for every voxel of the
// segment between the centres of two voxels, from the first to the last, both included.
#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace rc2::lines {

/// Coordinates of end points lie in -kMaxCoordinate .. kMaxCoordinate: up to there the algorithms
/// are exact and nothing overflows.
constexpr int kMaxCoordinate = 1 << 14;

/// The axis along which the segment is longest, the first of them when equal.
inline int driving_axis(glm::ivec3 way) {
  const glm::ivec3 length = glm::abs(way);
  if (length.x >= std::max(length.y, length.z)) return 0;
  return length.y >= length.z ? 1 : 2;
}

/// Steps from one end to the other when a step may change all three coordinates.
inline int steps_between(glm::ivec3 from, glm::ivec3 to) {
  const glm::ivec3 way = to - from;
  return glm::abs(way)[driving_axis(way)];
}

}  // namespace rc2::lines
