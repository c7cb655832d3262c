#include "sw/cycle/extents.h"

#include <algorithm>

#include "sw/cycle/cell.h"

namespace rc2::cycle {
namespace {

Extent joined(const Extent& a, const Extent& b) {
  return {std::min(a.min, b.min), std::max(a.max, b.max)};
}

Extent extent_of(const Columns& columns, std::size_t column, int n) {
  const int lowest = columns.next_occupied(column, 0);
  int highest = -1;
  for (int z = lowest; z < n; z = columns.next_occupied(column, z + 1)) highest = z;
  return {lowest, highest};
}

}  // namespace

Extents::Extents(int n) : n_(n) {
  const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  for (std::vector<Extent>& quadrant : quadrants_) quadrant.assign(cells, {n, -1});
}

Extent& Extents::at(std::size_t quadrant, int x, int y) {
  return quadrants_[quadrant][cell_number(x, y, n_)];
}

const Extent& Extents::at(std::size_t quadrant, int x, int y) const {
  return quadrants_[quadrant][cell_number(x, y, n_)];
}

void Extents::settle(const Columns& columns) {
  std::vector<Extent> own;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    own.push_back(extent_of(columns, column, n_));
  }
  for (std::size_t quadrant = 0; quadrant < quadrants_.size(); ++quadrant) {
    const int sx = (quadrant & 1U) != 0 ? 1 : -1, sy = (quadrant & 2U) != 0 ? 1 : -1;
    for (int i = n_ - 1; i >= 0; --i) {
      const int y = sy > 0 ? i : n_ - 1 - i;
      for (int j = n_ - 1; j >= 0; --j) {
        const int x = sx > 0 ? j : n_ - 1 - j;
        Extent extent = own[cell_number(x, y, n_)];
        if (j < n_ - 1) extent = joined(extent, at(quadrant, x + sx, y));
        if (i < n_ - 1) extent = joined(extent, at(quadrant, x, y + sy));
        at(quadrant, x, y) = extent;
      }
    }
  }
}

std::vector<Extent> Extents::beyond(const glm::ivec3& source) const {
  std::vector<Extent> all(quadrants_[0].size(), {n_, -1});
  for (std::size_t quadrant = 0; quadrant < quadrants_.size(); ++quadrant) {
    const bool east = (quadrant & 1U) != 0, north = (quadrant & 2U) != 0;
    for (int y = north ? source.y : 0; y <= (north ? n_ - 1 : source.y); ++y) {
      for (int x = east ? source.x : 0; x <= (east ? n_ - 1 : source.x); ++x) {
        Extent& extent = all[cell_number(x, y, n_)];
        extent = joined(extent, at(quadrant, x, y));
      }
    }
  }
  return all;
}

}  // namespace rc2::cycle
