#include "sw/picture/difference.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rc2::picture {

Difference difference(const Image& image, const Image& reference) {
  constexpr double kWrong = 0.05;
  Difference result;
  double squares = 0;
  for (std::size_t i = 0; i < image.colour.size(); ++i) {
    const glm::dvec3 off = glm::clamp(glm::dvec3(image.colour[i]), 0.0, 1.0) -
                           glm::clamp(glm::dvec3(reference.colour[i]), 0.0, 1.0);
    const double square = glm::dot(off, off) / 3;
    squares += square;
    if (square > kWrong * kWrong) result.wrong += 1;
  }
  const auto pixels = static_cast<double>(image.colour.size());
  result.wrong /= pixels;
  result.rmse = std::sqrt(squares / pixels);
  result.flip = flip(image, reference);
  return result;
}

}  // namespace rc2::picture
