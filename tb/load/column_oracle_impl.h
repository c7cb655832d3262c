#pragma once

#include <algorithm>

#include "tb/load/column_oracle.h"

namespace rc2::facet {

template <typename Integer>
Integer ColumnOracle<Integer>::dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Integer>
auto ColumnOracle<Integer>::cross(const Point& a, const Point& b) -> Point {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <typename Integer>
auto ColumnOracle<Integer>::minus(const Point& a, const Point& b) -> Point {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <typename Integer>
ColumnOracle<Integer>::ColumnOracle(const Border& border, std::int64_t one, Rule rule)
    : rule_(rule), voxel_(2 * one) {
  const Integer half = one;
  for (const Vertex& v : border) vertices_.push_back({2 * v.x, 2 * v.y, 2 * v.z});
  if (rule == Rule::naive) ends_ = {{half, 0, 0}, {0, half, 0}, {0, 0, half}};
  if (rule == Rule::armoured || rule == Rule::supercover)
    ends_ = {{half, half, half}, {half, half, -half}, {half, -half, half}, {half, -half, -half}};

  Point normal{};
  for (std::size_t i = 2; i < vertices_.size(); ++i) {
    const Point area =
        cross(minus(vertices_[i - 1], vertices_[0]), minus(vertices_[i], vertices_[0]));
    for (std::size_t k = 0; k < 3; ++k) normal[k] += area[k];
  }
  const std::array<Point, 3> units{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (rule == Rule::supercover) {
    add_shadow(normal, false);
    for (std::size_t k = 0; k < 3; ++k) {
      add_shadow(units[k], false);
      for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const Point side = minus(vertices_[(i + 1) % vertices_.size()], vertices_[i]);
        add_shadow(cross(units[k], side), normal[k] != 0);
      }
    }
    return;
  }
  add_slab(normal);
  add_sides(normal);
  if (rule == Rule::armoured || rule == Rule::naive)
    for (const Point& unit : units) add_shadow(unit, false);
}

// How far p + end or p - end may lie beyond p.
template <typename Integer>
Integer ColumnOracle<Integer>::farthest(const Point& towards) const {
  Integer most = 0;
  for (const Point& end : ends_) {
    const Integer along = dot(towards, end);
    most = std::max<Integer>({most, along, -along});
  }
  return most;
}

// Rules with guarantees look at p + (e, e^2, e^3), e -> 0+, the others at p itself.
template <typename Integer>
void ColumnOracle<Integer>::add(HalfSpaces& spaces, const Point& towards, const Point& from,
                                const Integer& reach) {
  const bool is_shifted = rule_ == Rule::armoured || rule_ == Rule::naive;
  const auto first =
      std::find_if(towards.begin(), towards.end(), [](const Integer& c) { return c != 0; });
  spaces.push_back({towards, from, reach, !is_shifted || first == towards.end() || *first > 0});
}

template <typename Integer>
void ColumnOracle<Integer>::add_slab(const Point& normal) {
  Integer reach = farthest(normal);
  Point direction = normal;
  if (rule_ == Rule::half || rule_ == Rule::blindee) {
    std::array<Integer, 3> size;
    for (std::size_t k = 0; k < 3; ++k) size[k] = normal[k] < 0 ? -normal[k] : normal[k];
    const Integer largest = *std::max_element(size.begin(), size.end());
    reach = voxel_ / 2 * largest;
    if (rule_ == Rule::blindee) {
      // Thesis 3.8: K sigma = K (1 + r) / 2 with r the largest min/max of two coefficients.
      Integer least = 0, most = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(size[k], size[(k + 1) % 3]);
        if (a * most > least * b) {
          least = a;
          most = b;
        }
      }
      reach *= least + most;
      for (Integer& c : direction) c *= most;
    }
  }
  add(all_, direction, vertices_[0], reach);
  add(all_, {-direction[0], -direction[1], -direction[2]}, vertices_[0], reach);
}

// The sides seen along the dominant axis, turned to where the other vertices are.
template <typename Integer>
void ColumnOracle<Integer>::add_sides(const Point& normal) {
  const auto size = [&](std::size_t k) { return normal[k] < 0 ? -normal[k] : normal[k]; };
  std::size_t axis = 2;
  for (const std::size_t k : {1U, 0U})
    if (size(k) > size(axis)) axis = k;
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Point along = minus(vertices_[(i + 1) % vertices_.size()], vertices_[i]);
    Point inwards{};
    inwards[u] = -along[v];
    inwards[v] = along[u];
    Integer middle = 0;
    for (const Point& other : vertices_) middle += dot(inwards, minus(other, vertices_[i]));
    if (middle < 0) inwards = {-inwards[0], -inwards[1], -inwards[2]};
    add(all_, inwards, vertices_[i], farthest(inwards));
    add(core_, inwards, vertices_[i], 0);
  }
}

// The facet's shadow on an axis, grown by the voxel's.
template <typename Integer>
void ColumnOracle<Integer>::add_shadow(const Point& axis, bool bounds_core) {
  const auto [low, high] = std::minmax_element(
      vertices_.begin(), vertices_.end(),
      [&](const Point& a, const Point& b) { return dot(axis, a) < dot(axis, b); });
  const Point back{-axis[0], -axis[1], -axis[2]};
  const Integer reach = farthest(axis);
  add(all_, axis, *low, reach);
  add(all_, back, *high, reach);
  if (!bounds_core) return;
  add(core_, axis, *low, 0);
  add(core_, back, *high, 0);
}

// Along a column a half-space holds on one side of one voxel only, which is found by halving.
template <typename Integer>
Span ColumnOracle<Integer>::narrowed(Span span, const HalfSpaces& spaces, int x, int y) const {
  for (const HalfSpace& space : spaces) {
    const Point foot = minus({voxel_ * x, voxel_ * y, 0}, space.from);
    const Integer base = dot(space.towards, foot) + space.reach;
    const Integer step = space.towards[2] * voxel_;
    const auto holds = [&](int z) {
      const Integer value = base + step * z;
      return value > 0 || (value == 0 && space.keeps_border);
    };
    const bool below = holds(span.first), above = holds(span.last);
    if (below && above) continue;
    if (!below && !above) return {0, -1};
    int in = below ? span.first : span.last, out = below ? span.last : span.first;
    while (in - out > 1 || out - in > 1) {
      const int middle = (in + out) / 2;
      (holds(middle) ? in : out) = middle;
    }
    (below ? span.last : span.first) = in;
  }
  return span;
}

template <typename Integer>
Column ColumnOracle<Integer>::column(int x, int y, int n) const {
  const Span voxels = narrowed({0, n - 1}, all_, x, y);
  if (voxels.first > voxels.last) return {voxels, voxels};
  return {voxels, narrowed(voxels, core_, x, y)};
}

}  // namespace rc2::facet
