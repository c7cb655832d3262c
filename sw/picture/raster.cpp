#include "sw/picture/raster.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>  // color_space.hpp needs it first
#include <glm/gtc/color_space.hpp>

namespace rc2::picture {
namespace {

constexpr int kStrip = 16;
constexpr std::array<std::uint8_t, 3> kPaper = {255, 255, 255};

std::array<std::uint8_t, 3> screen_colour(glm::vec3 linear) {
  const glm::vec3 srgb = glm::convertLinearToSRGB(linear);
  const auto byte = [](float share) { return static_cast<std::uint8_t>(std::lround(share * 255)); };
  return {byte(srgb.r), byte(srgb.g), byte(srgb.b)};
}

void paste(Raster& page, const Raster& picture, int left) {
  const int top = (page.height - picture.height) / 2;
  for (int row = 0; row < picture.height; ++row) {
    std::copy_n(picture.pixels.begin() + std::ptrdiff_t{row} * picture.width, picture.width,
                page.pixels.begin() + std::ptrdiff_t{top + row} * page.width + left);
  }
}

}  // namespace

Raster develop(const Image& image, int shortest_side) {
  const int square = std::max(1, (shortest_side + image.n - 1) / image.n);
  Raster raster;
  raster.width = raster.height = image.n * square;
  raster.pixels.reserve(static_cast<std::size_t>(raster.width) *
                        static_cast<std::size_t>(raster.height));
  for (int y = image.n - 1; y >= 0; --y) {
    const auto row = raster.pixels.size();
    for (int x = 0; x < image.n; ++x) {
      raster.pixels.insert(raster.pixels.end(), static_cast<std::size_t>(square),
                           screen_colour(image.colour[image.pixel(x, y)]));
    }
    for (int copy = 1; copy < square; ++copy) {
      for (int x = 0; x < raster.width; ++x) {
        raster.pixels.push_back(raster.pixels[row + static_cast<std::size_t>(x)]);
      }
    }
  }
  return raster;
}

Raster beside(const Raster& left, const Raster& right) {
  Raster page;
  page.width = left.width + kStrip + right.width;
  page.height = std::max(left.height, right.height);
  page.pixels.assign(static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height),
                     kPaper);
  paste(page, left, 0);
  paste(page, right, left.width + kStrip);
  return page;
}

}  // namespace rc2::picture
