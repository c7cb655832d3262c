#include "sw/surface/winding.h"

#include <algorithm>

#include "sw/base/floor_divide.h"

namespace rc2::surface {
namespace {

using facet::Vertex;

std::int64_t ceil_divide(std::int64_t numerator, std::int64_t denominator) {
  return -floor_divide(-numerator, denominator);
}

// Whether direction . shift > 0 for the shift (e, e^2, e^3), e -> 0+.
bool is_up(std::int64_t x, std::int64_t y, std::int64_t z = 0) {
  return x != 0 ? x > 0 : (y != 0 ? y > 0 : z > 0);
}

// The side of a triangle seen along z; its left is where the triangle is, if that turns left.
struct Side {
  Vertex from, along;
  Side(const Vertex& a, const Vertex& b) : from(a), along(b - a) {}

  bool has_on_left(std::int64_t x, std::int64_t y) const {
    const std::int64_t turn = along.x * (y - from.y) - along.y * (x - from.x);
    return turn != 0 ? turn > 0 : is_up(-along.y, along.x);
  }
};

class Columns {
 public:
  Columns(int n, int fraction_bits) : n_(n), one_(std::int64_t{1} << fraction_bits), winding_(n) {}

  // Notes at the highest voxel below the triangle, in each column that crosses it, what crossing
  // it upwards means: leaving (+1) or entering (-1).
  void cross(const Vertex& a, Vertex b, Vertex c) {
    Vertex normal = facet::cross(b - a, c - a);
    if (normal.z == 0) return;
    const std::int32_t leaving = normal.z > 0 ? 1 : -1;
    if (leaving < 0) {
      normal = -normal;
      std::swap(b, c);
    }
    const Side sides[] = {{a, b}, {b, c}, {c, a}};
    const std::int64_t level = facet::dot(normal, a), pitch = normal.z * one_;
    // A voxel on the plane is below it if the shift takes it there.
    const bool ties_below = !is_up(normal.x, normal.y, normal.z);
    const auto [x0, x1] = span({a.x, b.x, c.x});
    const auto [y0, y1] = span({a.y, b.y, c.y});
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const std::int64_t u = x * one_, v = y * one_;
        if (!std::all_of(std::begin(sides), std::end(sides),
                         [&](const Side& side) { return side.has_on_left(u, v); }))
          continue;
        const std::int64_t height = level - normal.x * u - normal.y * v;
        const std::int64_t below =
            ties_below ? floor_divide(height, pitch) : ceil_divide(height, pitch) - 1;
        if (below < 0) continue;
        winding_[{x, y, static_cast<int>(std::min<std::int64_t>(below, n_ - 1))}] += leaving;
      }
    }
  }

  // Adds up from the top of each column down.
  VoxelArray<std::int32_t> sum() && {
    for (int z = n_ - 2; z >= 0; --z)
      for (int y = 0; y < n_; ++y)
        for (int x = 0; x < n_; ++x) winding_[{x, y, z}] += winding_[{x, y, z + 1}];
    return std::move(winding_);
  }

 private:
  // Voxels of the grid whose centres are between the least and the greatest of the values.
  std::pair<int, int> span(std::initializer_list<std::int64_t> values) const {
    const auto [low, high] = std::minmax(values);
    return {static_cast<int>(std::max<std::int64_t>(0, ceil_divide(low, one_))),
            static_cast<int>(std::min<std::int64_t>(n_ - 1, floor_divide(high, one_)))};
  }

  int n_;
  std::int64_t one_;
  VoxelArray<std::int32_t> winding_;
};

}  // namespace

VoxelArray<std::int32_t> winding_numbers(const Mesh& mesh, int n) {
  Columns columns(n, mesh.fraction_bits);
  for (const facet::Border& border : mesh.facets)
    for (std::size_t i = 2; i < border.size(); ++i)
      columns.cross(border[0], border[i - 1], border[i]);
  return std::move(columns).sum();
}

}  // namespace rc2::surface
