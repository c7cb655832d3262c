// The ways between cells that messages about rays take.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

namespace rc2::cycle {

/// Directions between cells, and to oneself.
enum Way : unsigned { kEast, kWest, kNorth, kSouth, kHere };

/// Along axis 0 or 1, forwards (step 1) or backwards.
inline unsigned way_along(int axis, int step) {
  return (axis == 0 ? kEast : kNorth) + (step < 0 ? 1U : 0U);
}

/// The next way from a cell to another, one axis being done with before the other.
inline unsigned way_to(const glm::ivec2& from, const glm::ivec2& to, bool x_first) {
  const glm::ivec2 way = to - from;
  if (way == glm::ivec2(0)) return kHere;
  const int axis = (x_first ? way.x != 0 : way.y == 0) ? 0 : 1;
  return way_along(axis, way[axis]);
}

/// The number of the cell that way.
inline std::size_t neighbour(std::size_t cell, unsigned way, int n) {
  const std::size_t step = way < kNorth ? 1 : static_cast<std::size_t>(n);
  return way == kEast || way == kNorth ? cell + step : cell - step;
}

}  // namespace rc2::cycle
