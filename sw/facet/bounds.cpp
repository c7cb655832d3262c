#include "sw/facet/bounds.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <glm/common.hpp>

#include "sw/base/config.h"
#include "sw/base/floor_divide.h"

namespace rc2::facet {
namespace {

__extension__ using Wide = __int128;

// Closed rules keep points that lie exactly on a bound.
bool is_closed(Rule rule) { return rule != Rule::armoured && rule != Rule::naive; }

// The constant of the bound direction . p + numerator / denominator >= 0.
template <typename Integer>
std::int64_t bound_constant(const Vertex& direction, Integer numerator, Integer denominator,
                            Rule rule) {
  const bool ties = is_closed(rule) || keeps_ties(direction);
  return static_cast<std::int64_t>(floor_divide<Integer>(numerator - (ties ? 0 : 1), denominator));
}

struct Fraction {
  Wide numerator;
  std::int64_t denominator;
};

// Thickness w of the slab |N.(p - V0)| <= w/2 with K and S the largest and the sum of |A|,|B|,|C|.
Fraction slab_thickness(const Vertex& normal, Rule rule) {
  std::array<std::int64_t, 3> size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  std::sort(size.begin(), size.end());
  const auto [small, middle, large] = size;
  if (rule == Rule::naive || rule == Rule::half) return {large, 1};
  if (rule != Rule::blindee) return {large + middle + small, 1};
  // Thesis 3.8: w = 2 K sigma = K (1 + r), r the largest min/max over the pairs: middle/large or
  // small/middle.
  if (Wide(small) * large <= Wide(middle) * middle) return {large + middle, 1};
  return {Wide(large) * (small + middle), middle};
}

// Half the voxel's extent across the side: as an axis step (naive) or as a whole square.
std::int64_t side_offset(std::int64_t eu, std::int64_t ev, Rule rule) {
  switch (rule) {
    case Rule::naive:
      return std::max(std::abs(eu), std::abs(ev));
    case Rule::armoured:
    case Rule::supercover:
      return std::abs(eu) + std::abs(ev);
    default:
      return 0;
  }
}

class PacketWriter {
 public:
  PacketWriter(const Grid& grid, const Vertex& normal, const glm::ivec3& lo)
      : grid_(grid), normal_(normal), lo_(lo) {}

  Slab slab(const Vertex& on_plane) const {
    const Fraction w = slab_thickness(normal_, grid_.rule);
    const Wide level = Wide(2) * dot(normal_, on_plane) * w.denominator;
    const Wide reach = grid_.one * w.numerator;
    const Wide denominator = Wide(2) * grid_.one * w.denominator;
    const std::int64_t front = bound_constant(-normal_, level + reach, denominator, grid_.rule);
    const std::int64_t back = bound_constant(normal_, reach - level, denominator, grid_.rule);
    return {from_corner(normal_, back), front + back};
  }

  Linear gap(const Vertex& on_plane) const {
    const std::int64_t unit = std::int64_t{1} << gap_fraction_bits(grid_.n);
    const std::int64_t size = std::abs(normal_[dominant_axis(normal_)]);
    const auto rounded = [&](auto numerator, auto denominator) {
      return static_cast<std::int64_t>(
          floor_divide(2 * unit * numerator + denominator, 2 * denominator));
    };
    const Vertex corner = Vertex(lo_) * grid_.one - on_plane;
    return {rounded(normal_.x, size), rounded(normal_.y, size), rounded(normal_.z, size),
            rounded(Wide(dot(normal_, corner)), Wide(size) * grid_.one)};
  }

  // One per side of the border, seen along the axis (N must not be zero there).
  void add_sides(const Border& border, int axis, std::vector<Side>& sides) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const std::int64_t sign = normal_[axis] < 0 ? -1 : 1;
    for (std::size_t i = 0; i < border.size(); ++i) {
      const Vertex& from = border[i];
      const Vertex& to = border[i + 1 == border.size() ? 0 : i + 1];
      const std::int64_t eu = to[u] - from[u], ev = to[v] - from[v];
      Vertex inwards(0);
      inwards[u] = -sign * ev;
      inwards[v] = sign * eu;
      const std::int64_t level = 2 * sign * (ev * from[u] - eu * from[v]);
      const std::int64_t reach = grid_.one * side_offset(eu, ev, grid_.rule);
      const auto constant = [&](std::int64_t numerator) {
        return bound_constant(inwards, numerator, 2 * grid_.one, grid_.rule);
      };
      const std::int64_t pushed = constant(level + reach);
      sides.push_back({from_corner(inwards, pushed), pushed - constant(level)});
    }
  }

 private:
  Linear from_corner(const Vertex& a, std::int64_t d) const {
    return {a.x, a.y, a.z, d + dot(a, Vertex(lo_))};
  }

  const Grid& grid_;
  const Vertex& normal_;
  const glm::ivec3& lo_;
};

}  // namespace

Vertex plane_normal(const Border& border) {
  Vertex normal = cross(border[1] - border[0], border[2] - border[1]);
  const std::int64_t any = normal.x | normal.y | normal.z;
  return normal / (any & -any);
}

std::uint8_t facing(const Vertex& normal) {
  const std::int64_t size = std::abs(normal[dominant_axis(normal)]);
  int code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_large = 12 * std::abs(normal[axis]) >= 5 * size;
    code = 3 * code + (is_large ? (normal[axis] < 0 ? 0 : 2) : 1);
  }
  return static_cast<std::uint8_t>(code);
}

bool append_packet(const Border& border, const Vertex& normal, std::uint32_t facet,
                   const Grid& grid, PacketStream& stream) {
  // Nothing but the thesis's own inequalities may limit its facets: with sigma <= 1 their voxels
  // reach up to a whole voxel beyond the vertices, all others half a voxel.
  const std::int64_t grow = (grid.rule == Rule::blindee ? 2 : 1) * grid.one, two = 2 * grid.one;
  PacketHead head;
  head.facet = facet;
  head.facing = facing(normal);
  for (int axis = 0; axis < 3; ++axis) {
    std::int64_t low = border[0][axis], high = low;
    for (const Vertex& vertex : border) {
      low = std::min(low, vertex[axis]);
      high = std::max(high, vertex[axis]);
    }
    const std::int64_t end = 2 * high + grow - (is_closed(grid.rule) ? 0 : 1);
    head.lo[axis] = static_cast<int>(std::max<std::int64_t>(0, -floor_divide(grow - 2 * low, two)));
    head.hi[axis] = static_cast<int>(std::min<std::int64_t>(grid.n - 1, floor_divide(end, two)));
    if (head.lo[axis] > head.hi[axis]) return false;
  }
  const PacketWriter writer(grid, normal, head.lo);
  head.slab = writer.slab(border[0]);
  head.gap = writer.gap(border[0]);
  head.first_side = static_cast<std::uint32_t>(stream.sides.size());
  if (grid.rule == Rule::supercover) {
    for (int axis = 0; axis < 3; ++axis)
      if (normal[axis] != 0) writer.add_sides(border, axis, stream.sides);
  } else {
    writer.add_sides(border, dominant_axis(normal), stream.sides);
  }
  head.side_count = static_cast<std::uint32_t>(stream.sides.size()) - head.first_side;
  stream.heads.push_back(head);
  return true;
}

}  // namespace rc2::facet
