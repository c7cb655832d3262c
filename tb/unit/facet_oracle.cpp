#include "tb/unit/facet_oracle.h"

#include <algorithm>

namespace rc2::facet {

using boost::multiprecision::abs;

Oracle::Integer Oracle::dot(const Point& a, const Point& b) {
  return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
}

Oracle::Point Oracle::cross(const Point& a, const Point& b) {
  Point r;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    r.c[i] = a.c[j] * b.c[k] - a.c[k] * b.c[j];
  }
  return r;
}

Oracle::Point Oracle::minus(const Point& a, const Point& b) {
  return {{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
}

Oracle::Oracle(const Border& border, std::int64_t one, Rule rule) : rule_(rule), half_(one) {
  for (const Vertex& v : border) vertices_.push_back({{2 * v.x, 2 * v.y, 2 * v.z}});
  const std::size_t count = vertices_.size();
  low_ = high_ = vertices_[0];
  for (const Point& v : vertices_)
    for (int i = 0; i < 3; ++i) {
      low_.c[i] = std::min(low_.c[i], v.c[i]);
      high_.c[i] = std::max(high_.c[i], v.c[i]);
    }
  for (std::size_t i = 0; i < count; ++i) {
    const Point area = cross(vertices_[i], vertices_[(i + 1) % count]);
    for (int k = 0; k < 3; ++k) normal_.c[k] += area.c[k];
  }
  int dominant = 2;
  for (const int axis : {1, 0})
    if (abs(normal_.c[axis]) > abs(normal_.c[dominant])) dominant = axis;

  // Each side's normal within the dominant projection, turned to where the polygon's middle is.
  const int u = (dominant + 1) % 3, v = (dominant + 2) % 3;
  for (std::size_t i = 0; i < count; ++i) {
    const Point along = minus(vertices_[(i + 1) % count], vertices_[i]);
    Point a;
    a.c[u] = -along.c[v];
    a.c[v] = along.c[u];
    Integer middle = 0;
    for (const Point& other : vertices_) middle += dot(a, minus(other, vertices_[i]));
    if (middle < 0)
      for (Integer& c : a.c) c = -c;
    inwards_.push_back(a);
  }

  if (rule == Rule::naive) {
    reach_ = {{{half_, 0, 0}}, {{0, half_, 0}}, {{0, 0, half_}}};
  } else {
    for (int signs = 0; signs < 4; ++signs)
      reach_.push_back({{signs & 1 ? -half_ : half_, signs & 2 ? -half_ : half_, half_}});
  }

  // Thesis 3.8.
  Integer size[3] = {abs(normal_.c[0]), abs(normal_.c[1]), abs(normal_.c[2])};
  const Integer largest = std::max({size[0], size[1], size[2]});
  // sigma = (1 + ratio) / 2 with the largest min/max of the pairs.
  Integer little = 0, big = 1;
  if (rule == Rule::blindee)
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      const Integer least = std::min(size[i], size[j]), most = std::max(size[i], size[j]);
      if (least * big > little * most) {
        little = least;
        big = most;
      }
    }
  // K sigma, and our distances are in halves of a vertex step.
  thickness_ = half_ * largest * (big + little);
  thickness_divisor_ = big;

  for (int axis = 0; axis < 3; ++axis) {
    Point unit;
    unit.c[axis] = 1;
    axes_.push_back(unit);
    for (std::size_t i = 0; i < count; ++i)
      axes_.push_back(cross(unit, minus(vertices_[(i + 1) % count], vertices_[i])));
  }
  axes_.push_back(normal_);
}

// Sign of direction . (p - through) at p + (e, e^2, e^3), e -> 0+: zero only for no direction.
int Oracle::side_of(const Point& direction, const Point& through, const Point& p) const {
  const Integer value = dot(direction, minus(p, through));
  if (value != 0) return value > 0 ? 1 : -1;
  for (const Integer& c : direction.c)
    if (c != 0) return c > 0 ? 1 : -1;
  return 0;
}

bool Oracle::meets_plane(const Point& p) const {
  return std::any_of(reach_.begin(), reach_.end(), [&](const Point& r) {
    const Point a{{p.c[0] + r.c[0], p.c[1] + r.c[1], p.c[2] + r.c[2]}};
    return side_of(normal_, vertices_[0], a) * side_of(normal_, vertices_[0], minus(p, r)) <= 0;
  });
}

bool Oracle::meets_sides(const Point& p) const {
  for (std::size_t i = 0; i < inwards_.size(); ++i) {
    const bool reaches = std::any_of(reach_.begin(), reach_.end(), [&](const Point& r) {
      const Point a{{p.c[0] + r.c[0], p.c[1] + r.c[1], p.c[2] + r.c[2]}};
      return side_of(inwards_[i], vertices_[i], a) >= 0 ||
             side_of(inwards_[i], vertices_[i], minus(p, r)) >= 0;
    });
    if (!reaches) return false;
  }
  return true;
}

// At p + (e, e^2, e^3) the upper end is not included.
bool Oracle::meets_box(const Point& p) const {
  for (int i = 0; i < 3; ++i)
    if (p.c[i] + half_ < low_.c[i] || p.c[i] - half_ >= high_.c[i]) return false;
  return true;
}

bool Oracle::is_in_thick_polygon(const Point& p) const {
  const Integer distance = abs(dot(normal_, minus(p, vertices_[0])));
  if (distance * thickness_divisor_ > thickness_) return false;
  for (std::size_t i = 0; i < inwards_.size(); ++i)
    if (dot(inwards_[i], minus(p, vertices_[i])) < 0) return false;
  return true;
}

// Separating axes: two convex bodies are apart if their shadows on one of the axes are.
bool Oracle::touches_cube(const Point& p) const {
  for (const Point& axis : axes_) {
    const Integer centre = dot(axis, p);
    const Integer reach = half_ * (abs(axis.c[0]) + abs(axis.c[1]) + abs(axis.c[2]));
    Integer low = dot(axis, vertices_[0]), high = low;
    for (const Point& v : vertices_) {
      const Integer at = dot(axis, v);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    if (low > centre + reach || high < centre - reach) return false;
  }
  return true;
}

bool Oracle::has(const glm::ivec3& voxel) const {
  const Point p{{2 * half_ * voxel.x, 2 * half_ * voxel.y, 2 * half_ * voxel.z}};
  switch (rule_) {
    case Rule::armoured:
    case Rule::naive:
      return meets_box(p) && meets_plane(p) && meets_sides(p);
    case Rule::supercover:
      return touches_cube(p);
    case Rule::half:
    case Rule::blindee:
      return is_in_thick_polygon(p);
  }
  return false;
}

}  // namespace rc2::facet
