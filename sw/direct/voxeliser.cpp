#include "sw/direct/voxeliser.h"

#include <algorithm>
#include <cstdlib>

namespace rc2::direct {
namespace {

using Integer = std::int64_t;

// A number of half vertex units as a number of voxels, rounded down; so that no voxel lies on a
// bound that does not keep it, the bound is first made a trifle tighter.
Integer to_voxels(Integer halves, int fraction_bits, bool keeps_ties) {
  return (halves - (keeps_ties ? 0 : 1)) >> (fraction_bits + 1);
}

// The value of a side at a column, and how it changes; columns inside have none below 0.
struct Side {
  Integer outer, inner, value;
};

// t / k rounded up, and what that adds: value * k = t + added, 0 <= added < k. It follows a t that
// changes by k at most without another division.
struct Quotient {
  Integer value, added;

  Quotient(Integer t, Integer k) : value(t / k), added(value * k - t) { carry(k); }

  void step(Integer change, Integer k) {
    added -= change;
    carry(k);
  }

  void carry(Integer k) {
    if (added < 0) {
      added += k;
      ++value;
    } else if (added >= k) {
      added -= k;
      --value;
    }
  }
};

}  // namespace

Voxeliser::Voxeliser(int n, int fraction_bits)
    : n_(n),
      fraction_bits_(fraction_bits),
      one_(1 << fraction_bits),
      lowest_(fraction_bits == 0 ? 0 : -one_ / 2),
      end_(fraction_bits == 0 ? n : n * one_ - one_ / 2 + 1),
      stride_{std::ptrdiff_t{n} * n, n, 1},
      owners_(static_cast<std::size_t>(n) * n * n, kFree) {}

void Voxeliser::fill(const scene::Scene& scene) {
  const auto polygons = static_cast<std::uint32_t>(scene.polygon_count());
  Triangle triangle;
  for (std::uint32_t i = 0; i < polygons; ++i) {
    if (scene.first[i + 1] - scene.first[i] != 3) continue;
    const glm::dvec3* corners = &scene.vertices[scene.first[i]];
    if (round(corners[0], triangle[0]) && round(corners[1], triangle[1]) &&
        round(corners[2], triangle[2])) {
      fill(triangle, i);
    }
  }
}

bool Voxeliser::round(const glm::dvec3& corner, Vertex& vertex) const {
  for (int axis = 0; axis < 3; ++axis) {
    const double value = corner[axis] * one_ + 0.5;
    if (!(value >= lowest_ && value < end_)) return false;
    const auto whole = static_cast<Integer>(value);
    vertex[axis] = whole - (static_cast<double>(whole) > value ? 1 : 0);
  }
  return true;
}

void Voxeliser::fill(const Triangle& p, std::uint32_t number) {
  const Vertex e = p[1] - p[0], f = p[2] - p[1];
  Vertex normal(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
  const Integer a = std::abs(normal.x), b = std::abs(normal.y), c = std::abs(normal.z);
  const Integer k = std::max({a, b, c});
  if (k == 0) return;

  // Columns run along the axis that the plane crosses soonest. Of the other two axes z, along which
  // memory runs, is the inner one.
  const int along = c == k ? 2 : b == k ? 1 : 0;
  const int outer = along == 1 ? 0 : 1, inner = along == 2 ? 0 : 2;

  const Integer one = Integer{1} << fraction_bits_;
  std::array<Integer, 3> low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, most] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
    low[axis] = std::max<Integer>(0, -to_voxels(one - 2 * least, fraction_bits_, true));
    high[axis] = std::min<Integer>(n_ - 1, to_voxels(2 * most + one, fraction_bits_, false));
    if (low[axis] > high[axis]) return;
  }

  const Integer turn = (normal[along] > 0) == (along != 0) ? 1 : -1;
  std::array<Side, 3> sides;
  for (int i = 0; i < 3; ++i) {
    const Vertex &from = p[i], edge = p[i == 2 ? 0 : i + 1] - from;
    const Integer u = turn * edge[inner], v = -turn * edge[outer];
    const Integer leading = u != 0 && (v == 0 || outer < inner) ? u : v;
    const Integer level = -2 * (u * from[outer] + v * from[inner]);
    const Integer reach = one * (std::abs(u) + std::abs(v));
    const Integer constant = to_voxels(level + reach, fraction_bits_, leading > 0);
    sides[i] = {u, v, u * low[outer] + v * low[inner] + constant};
  }

  // The slab: least <= normal . voxel <= least + thickness.
  if (normal[along] < 0) normal = -normal;
  const Integer leading = normal.x != 0 ? normal.x : (normal.y != 0 ? normal.y : normal.z);
  const Integer level = 2 * (normal.x * p[0].x + normal.y * p[0].y + normal.z * p[0].z);
  const Integer reach = one * (a + b + c);
  const Integer least = -to_voxels(reach - level, fraction_bits_, leading > 0);
  const Integer thickness = to_voxels(reach + level, fraction_bits_, leading < 0) - least;

  const Integer first = low[along], last = high[along];
  const std::ptrdiff_t stride = stride_[along], next = stride_[inner];
  const Integer corner = normal[outer] * low[outer] + normal[inner] * low[inner];
  Quotient row_bottom(least - corner, k);
  std::uint32_t* row = owners_.data() + low[outer] * stride_[outer] + low[inner] * stride_[inner];
  for (Integer v = low[outer]; v <= high[outer]; ++v) {
    Integer s0 = sides[0].value, s1 = sides[1].value, s2 = sides[2].value;
    Quotient bottom = row_bottom;
    std::uint32_t* column = row;
    for (Integer u = low[inner]; u <= high[inner]; ++u) {
      if ((s0 | s1 | s2) >= 0) {
        Integer w = bottom.value;
        for (Integer rest = thickness - bottom.added; rest >= 0 && w <= last; rest -= k, ++w) {
          if (w < first) continue;
          std::uint32_t& owner = column[w * stride];
          owner = std::min(owner, number);
        }
      }
      s0 += sides[0].inner;
      s1 += sides[1].inner;
      s2 += sides[2].inner;
      bottom.step(-normal[inner], k);
      column += next;
    }
    for (Side& side : sides) side.value += side.outer;
    row_bottom.step(-normal[outer], k);
    row += stride_[outer];
  }
}

std::int64_t Voxeliser::voxel_count() const {
  return static_cast<std::int64_t>(owners_.size()) -
         std::count(owners_.begin(), owners_.end(), kFree);
}

}  // namespace rc2::direct
