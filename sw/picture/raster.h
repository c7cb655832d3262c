// Pictures ready for a screen: 8 bits per channel, sRGB.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sw/picture/image.h"

namespace rc2::picture {

/// Pixels row by row from the top.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;
};

/// The colours of an image, clamped to 0..1. Each pixel becomes a square of whole pixels, as small
/// as gives the raster sides of at least `shortest_side`.
Raster develop(const Image& image, int shortest_side = 512);

/// Both pictures in one, in the middle of its height, with a strip between them.
Raster beside(const Raster& left, const Raster& right);

}  // namespace rc2::picture
