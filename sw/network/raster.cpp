#include "sw/network/raster.h"

#include "sw/lines/digital_line.h"

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
  std::vector<glm::ivec2> pixels{{0, 0}};
  lines::DigitalLine y(height, n);
  while (pixels.back().x < n) pixels.push_back(pixels.back() + glm::ivec2(1, y.advance()));
  return pixels;
}

}  // namespace rc2::network
