#include "sw/surface/bilinear.h"

#include <algorithm>
#include <utility>

#include "sw/surface/outline.h"

namespace rc2::surface {
namespace {

bool is_less(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator < b.numerator * a.denominator;
}

bool is_before(const Crossing& a, const Crossing& b) {
  return is_less(a.x, b.x) || (!is_less(b.x, a.x) && is_less(a.z, b.z));
}

void fill_line(Crossing left, Crossing right, std::int64_t y, VoxelSet& voxels) {
  if (is_before(right, left)) std::swap(left, right);
  const std::int64_t first = nearest(left.x), columns = nearest(right.x) - first;
  // z = left + (right - left) * i / columns over one denominator
  const std::int64_t low = left.z.numerator * right.z.denominator,
                     high = right.z.numerator * left.z.denominator,
                     denominator = left.z.denominator * right.z.denominator;
  for (std::int64_t i = 0; i <= columns; ++i) {
    const std::int64_t z = columns == 0
                               ? nearest(left.z)
                               : nearest({low * columns + (high - low) * i, denominator * columns});
    voxels[glm::ivec3(first + i, y, z)] = 1;
  }
}

}  // namespace

void fill_bilinear(const facet::Border& border, VoxelSet& voxels) {
  const auto [lowest, highest] = std::minmax_element(
      border.begin(), border.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  if (lowest->y == highest->y) {
    const auto corner = [](const facet::Vertex& at) { return Crossing{{at.x, 1}, {at.z, 1}}; };
    const auto [left, right] = std::minmax_element(
        border.begin(), border.end(),
        [&](const auto& a, const auto& b) { return is_before(corner(a), corner(b)); });
    fill_line(corner(*left), corner(*right), lowest->y, voxels);
    return;
  }
  Outline one(border, +1), other(border, -1);
  for (std::int64_t y = highest->y; y >= lowest->y; --y)
    fill_line(one.at(y), other.at(y), y, voxels);
}

}  // namespace rc2::surface
