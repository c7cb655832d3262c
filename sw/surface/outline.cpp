#include "sw/surface/outline.h"

#include <algorithm>

namespace rc2::surface {

Outline::Outline(const facet::Border& border, int turn)
    : border_(border), turn_(static_cast<std::size_t>(turn)) {
  const auto highest = std::max_element(border.begin(), border.end(),
                                        [](const auto& a, const auto& b) { return a.y < b.y; });
  to_ = static_cast<std::size_t>(highest - border.begin());
  do {
    from_ = to_;
    to_ = next(to_);
  } while (border_[to_].y == border_[from_].y);
}

Crossing Outline::at(std::int64_t y) {
  while (border_[to_].y > y) {
    from_ = to_;
    to_ = next(to_);
  }
  const facet::Vertex& upper = border_[from_];
  const facet::Vertex side = border_[to_] - upper;
  const std::int64_t down = upper.y - y, height = -side.y;
  const auto value = [&](std::int64_t start, std::int64_t change) {
    return Fraction{start * height + change * down, height};
  };
  return {value(upper.x, side.x), value(upper.z, side.z)};
}

}  // namespace rc2::surface
