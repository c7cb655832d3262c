#include <algorithm>
#include <numeric>

#include "sw/facet/polygon.h"

namespace rc2::facet {
namespace {

// The border seen along an axis, turned so that it goes round counter-clockwise.
struct View {
  int u, v;
  std::int64_t sign;

  // > 0 if a, b, c turn left.
  std::int64_t turn(const Vertex& a, const Vertex& b, const Vertex& c) const {
    return sign * ((b[u] - a[u]) * (c[v] - b[v]) - (b[v] - a[v]) * (c[u] - b[u]));
  }
  bool same_place(const Vertex& a, const Vertex& b) const { return a[u] == b[u] && a[v] == b[v]; }
};

View view_of(const Border& border) {
  const Vertex area = doubled_area(border);
  const int axis = dominant_axis(area);
  return {(axis + 1) % 3, (axis + 2) % 3, area[axis] < 0 ? -1 : 1};
}

// The corners still to be cut, as indices into the border.
class Remaining {
 public:
  Remaining(const Border& border, const View& view)
      : border_(border), view_(view), corners_(border.size()) {
    std::iota(corners_.begin(), corners_.end(), std::size_t{0});
  }

  std::size_t count() const { return corners_.size(); }
  const Vertex& at(std::size_t i) const { return border_[corners_[i % corners_.size()]]; }
  Triangle triangle(std::size_t i) const { return {at(i + count() - 1), at(i), at(i + 1)}; }
  void cut(std::size_t i) { corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(i)); }

  bool is_ear(std::size_t i) const {
    const auto [a, b, c] = triangle(i);
    if (view_.turn(a, b, c) <= 0) return false;
    for (std::size_t k = i + 2; k < i + count() - 1; ++k) {
      const Vertex& p = at(k);
      const bool is_corner =
          view_.same_place(p, a) || view_.same_place(p, b) || view_.same_place(p, c);
      if (!is_corner && view_.turn(a, b, p) >= 0 && view_.turn(b, c, p) >= 0 &&
          view_.turn(c, a, p) >= 0)
        return false;
    }
    return true;
  }

 private:
  const Border& border_;
  View view_;
  std::vector<std::size_t> corners_;
};

}  // namespace

void triangulate(const Border& border, std::vector<Triangle>& triangles) {
  Remaining rest(border, view_of(border));
  std::size_t start = 0;
  while (rest.count() > 3) {
    // A border that crosses itself may run out of ears; any corner then keeps every side in use.
    std::size_t ear = start % rest.count();
    for (std::size_t tried = 0; tried < rest.count(); ++tried) {
      const std::size_t candidate = (start + tried) % rest.count();
      if (rest.is_ear(candidate)) {
        ear = candidate;
        break;
      }
    }
    triangles.push_back(rest.triangle(ear));
    rest.cut(ear);
    start = ear;
  }
  triangles.push_back(rest.triangle(1));
}

}  // namespace rc2::facet
