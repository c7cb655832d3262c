#include "sw/facet/above.h"

#include <algorithm>

#include "sw/base/floor_divide.h"
#include "sw/facet/bounds.h"

namespace rc2::facet {
namespace {

// direction . (p - through / one) > 0 as a bound for p.
Linear half_space(const Vertex& direction, const Vertex& through, std::int64_t one) {
  const std::int64_t level = dot(direction, through) + (keeps_ties(direction) ? 0 : 1);
  return {direction.x, direction.y, direction.z, floor_divide(-level, one)};
}

std::int64_t value_at(const Linear& value, const Vertex& p) {
  return value.a * p.x + value.b * p.y + value.c * p.z + value.d;
}

// What is on the upper side of a facet that is not on edge, and between the upright planes through
// its sides.
class Prism {
 public:
  Prism(const Border& border, const Vertex& normal, std::int64_t one)
      : border_(border), normal_(normal), one_(one), sign_(normal.z < 0 ? -1 : 1) {}

  Linear top() const { return half_space(sign_ * normal_, border_[0], one_); }

  Linear side(std::size_t i) const {
    const Vertex& from = border_[i];
    const Vertex along = border_[i + 1 == border_.size() ? 0 : i + 1] - from;
    return half_space(sign_ * Vertex(-along.y, along.x, 0), from, one_);
  }

 private:
  const Border& border_;
  const Vertex& normal_;
  std::int64_t one_, sign_;
};

struct Range {
  std::int64_t low, high;
};

Range extent(const Border& border, int axis) {
  Range range{border[0][axis], border[0][axis]};
  for (const Vertex& vertex : border) {
    range.low = std::min(range.low, vertex[axis]);
    range.high = std::max(range.high, vertex[axis]);
  }
  return range;
}

}  // namespace

bool is_over(const Border& border, const Vertex& normal, const Vertex& point) {
  if (normal.z == 0) return false;
  for (int axis = 0; axis < 2; ++axis) {
    const Range range = extent(border, axis);
    if (point[axis] < range.low || point[axis] >= range.high) return false;
  }
  const Prism prism(border, normal, 1);
  for (std::size_t i = 0; i < border.size(); ++i)
    if (value_at(prism.side(i), point) < 0) return false;
  return value_at(prism.top(), point) < 0;
}

void append_above(const Border& border, const Vertex& normal, std::uint32_t facet, int n,
                  std::int64_t one, PacketStream& stream) {
  if (normal.z == 0) return;
  PacketHead head{};
  head.facet = facet;
  head.layer = Layer::inside;
  head.hi.z = n - 1;
  for (int axis = 0; axis < 2; ++axis) {
    const Range range = extent(border, axis);
    const std::int64_t first = -floor_divide(-range.low, one);
    const std::int64_t last = floor_divide(range.high - 1, one);
    head.lo[axis] = static_cast<int>(std::max<std::int64_t>(first, 0));
    head.hi[axis] = static_cast<int>(std::min<std::int64_t>(last, n - 1));
    if (head.lo[axis] > head.hi[axis]) return;
  }
  const auto from_corner = [&](Linear value) {
    value.d = value_at(value, Vertex(head.lo));
    return value;
  };
  const Prism prism(border, normal, one);
  head.slab = {from_corner(prism.top()), 0};
  head.first_side = static_cast<std::uint32_t>(stream.sides.size());
  head.side_count = static_cast<std::uint32_t>(border.size());
  for (std::size_t i = 0; i < border.size(); ++i)
    stream.sides.push_back({from_corner(prism.side(i)), 0});
  stream.heads.push_back(head);
}

}  // namespace rc2::facet
