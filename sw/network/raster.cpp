#include "sw/network/raster.h"

namespace rc2::network {

std::vector<glm::ivec2> circle_arc(int radius) {
  std::vector<glm::ivec2> pixels;
  glm::ivec2 at(radius, 0);
  int excess = 0;  // x^2 + y^2 - R^2
  while (at.y <= at.x) {
    pixels.push_back(at);
    excess += 2 * at.y + 1;
    ++at.y;
    // (x - 1/2)^2 + y^2 > R^2, in integers: the circle passes left of the midpoint.
    if (excess >= at.x) {
      excess -= 2 * at.x - 1;
      --at.x;
    }
  }
  return pixels;
}

std::vector<glm::ivec2> segment(int n, int height) {
  std::vector<glm::ivec2> pixels;
  int error = n;  // in units of 1/2n of a pixel, half a pixel to begin with
  for (glm::ivec2 at(0, 0); at.x <= n; ++at.x) {
    pixels.push_back(at);
    error += 2 * height;
    if (error >= 2 * n) {
      ++at.y;
      error -= 2 * n;
    }
  }
  return pixels;
}

}  // namespace rc2::network
