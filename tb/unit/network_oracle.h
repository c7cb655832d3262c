// Which pixels a drawing has, from the definition: distances in exact integers, no stepping.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace rc2::network {

/// Is x the integer nearest to sqrt(R^2 - y^2)? Asked of pixels with 0 <= y <= x.
inline bool on_circle(std::int64_t radius, glm::ivec2 at) {
  const std::int64_t x = at.x;
  const std::int64_t square = radius * radius - std::int64_t{at.y} * at.y;
  if (square < 0) return false;
  return x == 0 ? square == 0
                : (2 * x - 1) * (2 * x - 1) < 4 * square && 4 * square < (2 * x + 1) * (2 * x + 1);
}

/// Is y the integer nearest to height * x / n, ties downwards?
inline bool on_segment(std::int64_t n, std::int64_t height, glm::ivec2 at) {
  const std::int64_t twice = 2 * (height * at.x - n * at.y);
  return -n < twice && twice <= n;
}

/// The same, ties upwards, as thesis 2.3.1 prints it.
inline bool on_printed_segment(std::int64_t n, std::int64_t height, glm::ivec2 at) {
  const std::int64_t twice = 2 * (height * at.x - n * at.y);
  return -n <= twice && twice < n;
}

}  // namespace rc2::network
