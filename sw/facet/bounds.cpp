#include "sw/facet/bounds.h"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>

#include "sw/base/config.h"
#include "sw/base/floor_divide.h"

namespace rc2::facet {
namespace {

__extension__ using Wide = __int128;

// Closed rules keep points that lie exactly on a bound.
bool is_closed(Rule rule) { return rule != Rule::armoured && rule != Rule::naive; }

// floor(F w), w the thickness of the slab |N.(p - V0)| <= w/2, with K and S the largest and the sum
// of |A|,|B|,|C|.
std::int64_t slab_thickness(const Vertex& normal, const Grid& grid) {
  const std::int64_t a = std::abs(normal.x), b = std::abs(normal.y), c = std::abs(normal.z);
  const std::int64_t sum = a + b + c, large = std::max({a, b, c});
  if (grid.rule == Rule::naive || grid.rule == Rule::half) return grid.one * large;
  if (grid.rule != Rule::blindee) return grid.one * sum;
  // Thesis 3.8: w = 2 K sigma = K (1 + r), r the largest min/max over the pairs: middle/large or
  // small/middle.
  const std::int64_t small = std::min({a, b, c}), middle = sum - large - small;
  if (Wide(small) * large <= Wide(middle) * middle) return grid.one * (large + middle);
  return grid.one * large + static_cast<std::int64_t>(Wide(grid.one) * large * small / middle);
}

// Half the voxel's extent across a side: as an axis step (naive) or as a whole square.
std::int64_t side_offset(const Vertex& inwards, Rule rule) {
  const std::int64_t a = std::abs(inwards.x), b = std::abs(inwards.y), c = std::abs(inwards.z);
  switch (rule) {
    case Rule::naive:
      return std::max({a, b, c});
    case Rule::armoured:
    case Rule::supercover:
      return a + b + c;
    default:
      return 0;
  }
}

class PacketWriter {
 public:
  PacketWriter(const Grid& grid, const Vertex& normal, const glm::ivec3& lo)
      : grid_(grid), normal_(normal), lo_(lo), axis_(dominant_axis(normal)) {}

  // The floor of F w serves as well as F w: the rest of a bound's numerator is an integer.
  Slab slab(const Vertex& on_plane, std::int64_t thickness) const {
    const std::int64_t level = 2 * dot(normal_, on_plane);
    const std::int64_t front = bound_constant(-normal_, level + thickness);
    const std::int64_t back = bound_constant(normal_, thickness - level);
    return {from_corner(normal_, back), front + back};
  }

  Linear gap(const Vertex& on_plane) const {
    const std::int64_t unit = std::int64_t{1} << gap_fraction_bits(grid_.n);
    const auto rounded = [&](std::int64_t numerator, std::int64_t denominator) {
      return floor_divide(2 * unit * numerator + denominator, 2 * denominator);
    };
    const std::int64_t size = std::abs(normal_[axis_]);
    const std::int64_t voxel = size * grid_.one;
    const std::int64_t distance = dot(normal_, Vertex(lo_) * grid_.one - on_plane);
    // What is beyond whole voxels is less than 2^44, and 2^61 when scaled.
    const std::int64_t whole = floor_divide(distance, voxel);
    return {rounded(normal_.x, size), rounded(normal_.y, size), rounded(normal_.z, size),
            unit * whole + rounded(distance - whole * voxel, voxel)};
  }

  // Seen along the axis of N's largest component; for supercover along every axis but those that
  // see the plane edge-on.
  void add_sides(const Border& border, std::vector<Side>& sides) const {
    if (grid_.rule != Rule::supercover) return add_sides(border, axis_, sides);
    for (int axis = 0; axis < 3; ++axis)
      if (normal_[axis] != 0) add_sides(border, axis, sides);
  }

 private:
  // One per side of the border; inwards is at right angles to the axis.
  void add_sides(const Border& border, int axis, std::vector<Side>& sides) const {
    Vertex along(0);
    along[axis] = normal_[axis] < 0 ? -1 : 1;
    const std::size_t first = sides.size();
    sides.resize(first + border.size());
    for (std::size_t i = 0; i < border.size(); ++i) {
      const Vertex& from = border[i];
      const Vertex& to = border[i + 1 == border.size() ? 0 : i + 1];
      const Vertex inwards = cross(along, to - from);
      const std::int64_t level = -2 * dot(inwards, from);
      const std::int64_t reach = grid_.one * side_offset(inwards, grid_.rule);
      const std::int64_t pushed = bound_constant(inwards, level + reach);
      sides[first + i] = {from_corner(inwards, pushed), pushed - bound_constant(inwards, level)};
    }
  }

  // The constant of the bound direction . p + numerator / 2F >= 0.
  std::int64_t bound_constant(const Vertex& direction, std::int64_t numerator) const {
    const bool ties = is_closed(grid_.rule) || keeps_ties(direction);
    return grid_.floor_halves(numerator - (ties ? 0 : 1));
  }

  Linear from_corner(const Vertex& a, std::int64_t d) const {
    return {a.x, a.y, a.z, d + dot(a, Vertex(lo_))};
  }

  const Grid& grid_;
  const Vertex& normal_;
  const glm::ivec3& lo_;
  int axis_;  // along which the plane is crossed soonest
};

// `thickness` is floor(F w) of the slab; the box goes beyond the border by half of `grow` / F.
bool append(const Border& border, const Vertex& normal, std::uint32_t facet, const Grid& grid,
            std::int64_t thickness, const Vertex& grow, PacketStream& stream) {
  Vertex low = border[0], high = low;
  for (const Vertex& vertex : border) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  glm::ivec3 lo, hi;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t first = -grid.floor_halves(grow[axis] - 2 * low[axis]);
    const std::int64_t last =
        grid.floor_halves(2 * high[axis] + grow[axis] - (is_closed(grid.rule) ? 0 : 1));
    lo[axis] = static_cast<int>(std::max<std::int64_t>(0, first));
    hi[axis] = static_cast<int>(std::min<std::int64_t>(grid.n - 1, last));
    if (lo[axis] > hi[axis]) return false;
  }
  const PacketWriter writer(grid, normal, lo);
  PacketHead& head = stream.heads.emplace_back();
  head.facet = facet;
  head.lo = lo;
  head.hi = hi;
  head.slab = writer.slab(border[0], thickness);
  head.gap = writer.gap(border[0]);
  head.first_side = static_cast<std::uint32_t>(stream.sides.size());
  writer.add_sides(border, stream.sides);
  head.side_count = static_cast<std::uint32_t>(stream.sides.size()) - head.first_side;
  return true;
}

}  // namespace

Vertex plane_normal(const Border& border) {
  Vertex normal = cross(border[1] - border[0], border[2] - border[1]);
  const int shared =
      __builtin_ctzll(static_cast<unsigned long long>(normal.x | normal.y | normal.z));
  return normal >> Vertex(shared);
}

bool append_packet(const Border& border, const Vertex& normal, std::uint32_t facet,
                   const Grid& grid, PacketStream& stream) {
  // Nothing but the thesis's own inequalities may limit its facets: with sigma <= 1 their voxels
  // reach up to a whole voxel beyond the vertices, all others half a voxel.
  const std::int64_t grow = (grid.rule == Rule::blindee ? 2 : 1) * grid.one;
  return append(border, normal, facet, grid, slab_thickness(normal, grid), Vertex(grow), stream);
}

bool append_guard(const Border& border, const Vertex& normal, std::uint32_t facet, Surface surface,
                  int n, std::int64_t one, PacketStream& stream) {
  const glm::i64vec3 sizes = glm::abs(normal);
  const int axis = dominant_axis(normal);
  const std::int64_t sum = sizes.x + sizes.y + sizes.z, large = sizes[axis];
  const std::int64_t width = 2 * sum + (surface == Surface::sheet ? large : 0);
  Vertex grow(one);
  grow[axis] = (width + large - 1) / large * one;
  const Grid grid{n, one, Rule::half};
  if (!append(border, normal, facet, grid, one * width, grow, stream)) return false;
  stream.heads.back().layer = Layer::guard;
  stream.heads.back().surface = surface;
  return true;
}

}  // namespace rc2::facet
