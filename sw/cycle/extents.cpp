#include "sw/cycle/extents.h"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <limits>

#include "sw/cycle/cell.h"

namespace rc2::cycle {
namespace {

constexpr Extent kNothing{0, -1};
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

Extent extent_of(const Columns& columns, std::size_t column, int n) {
  const int lowest = columns.next_occupied(column, 0);
  int highest = -1;
  for (int z = lowest; z < n; z = columns.next_occupied(column, z + 1)) highest = z;
  return {lowest, highest};
}

Tilts joined(const Tilts& a, const Tilts& b) {
  return {std::min(a.min, b.min), std::max(a.max, b.max)};
}

/// Calls visit(wx, wy, next) of each way that light can go on from a cell: back towards its source
/// on no axis; `next` if that is to the next ring, else within the ring.
template <typename Visit>
void for_each_way(int dx, int dy, Visit visit) {
  const int ring = std::max(std::abs(dx), std::abs(dy));
  for (int wy = -1; wy <= 1; ++wy) {
    for (int wx = -1; wx <= 1; ++wx) {
      if ((wx == 0 && wy == 0) || wx * dx < 0 || wy * dy < 0) continue;
      visit(wx, wy, std::max(std::abs(dx + wx), std::abs(dy + wy)) > ring);
    }
  }
}

}  // namespace

Extents::Extents(int n) : n_(n), tilt_(n) {
  const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  own_.assign(cells, kNothing);
  for (std::vector<bool>& quadrant : occupied_) quadrant.assign(cells, false);
}

void Extents::settle(const Columns& columns) {
  for (std::size_t column = 0; column < columns.size(); ++column) {
    own_[column] = extent_of(columns, column, n_);
  }
  for (std::size_t quadrant = 0; quadrant < occupied_.size(); ++quadrant) {
    const int sx = (quadrant & 1U) != 0 ? 1 : -1, sy = (quadrant & 2U) != 0 ? 1 : -1;
    std::vector<bool>& occupied = occupied_[quadrant];
    for (int i = n_ - 1; i >= 0; --i) {
      const int y = sy > 0 ? i : n_ - 1 - i;
      for (int j = n_ - 1; j >= 0; --j) {
        const int x = sx > 0 ? j : n_ - 1 - j;
        occupied[cell_number(x, y, n_)] = !own_[cell_number(x, y, n_)].none() ||
                                          (j < n_ - 1 && occupied[cell_number(x + sx, y, n_)]) ||
                                          (i < n_ - 1 && occupied[cell_number(x, y + sy, n_)]);
      }
    }
  }
}

bool Extents::anything(int x, int y, const glm::ivec3& source) const {
  for (std::size_t quadrant = 0; quadrant < occupied_.size(); ++quadrant) {
    const bool east = (quadrant & 1U) != 0, north = (quadrant & 2U) != 0;
    const bool away =
        (east ? x >= source.x : x <= source.x) && (north ? y >= source.y : y <= source.y);
    if (away && occupied_[quadrant][cell_number(x, y, n_)]) return true;
  }
  return false;
}

std::vector<Outlook> Extents::seen_from(const glm::ivec3& source) const {
  const Tilts none{tilt_.most(), -tilt_.most()};
  const Extent all{0, n_ - 1};
  std::vector<Sector> sectors(own_.size(), {none, 0});
  std::vector<Outlook> outlooks(own_.size(), {kNothing, kNothing, kNever});
  const auto ring = [&](int distance, auto visit) {
    for (int y = std::max(source.y - distance, 0); y <= std::min(source.y + distance, n_ - 1);
         ++y) {
      const bool whole = std::abs(y - source.y) == distance;
      for (int dx = -distance; dx <= distance; dx += whole ? 1 : std::max(2 * distance, 1)) {
        const int x = source.x + dx;
        if (x >= 0 && x < n_) visit(x, y, dx, y - source.y);
      }
    }
  };
  const auto join = [&](Sector& sector, int dx, int dy, auto counts) {
    for_each_way(dx, dy, [&](int wx, int wy, bool next) {
      const int x = source.x + dx + wx, y = source.y + dy + wy;
      if (!counts(wx, next) || x < 0 || y < 0 || x >= n_ || y >= n_) return;
      const Sector& other = sectors[cell_number(x, y, n_)];
      sector.tilts = joined(sector.tilts, other.tilts);
      sector.since = std::max(sector.since, other.since);
    });
  };
  const glm::ivec3 far = glm::max(source, n_ - 1 - source);
  for (int distance = std::max(far.x, far.y); distance >= 0; --distance) {
    ring(distance, [&](int x, int y, int dx, int dy) {
      if (!anything(x, y, source)) return;
      const Extent& own = own_[cell_number(x, y, n_)];
      Sector sector{none, 1};
      if (!own.none()) {
        sector = {{tilt_.of(own.min - source.z, distance, false),
                   tilt_.of(own.max - source.z, distance, true)},
                  tilt_.divided()};
      }
      // The light's own cell has eight neighbours: those to the east, to the west a cycle later,
      // and the two between them as others join what is within their ring.
      join(sector, dx, dy, [&](int wx, bool next) { return next && (distance > 0 || wx > 0); });
      ++sector.since;
      if (distance == 0) {
        join(sector, dx, dy, [](int wx, bool) { return wx < 0; });
        ++sector.since;
      }
      sectors[cell_number(x, y, n_)] = sector;
    });
    ring(distance, [&](int x, int y, int dx, int dy) {
      if (!anything(x, y, source)) return;
      Sector seen = sectors[cell_number(x, y, n_)];
      join(seen, dx, dy, [&](int wx, bool next) { return distance > 0 ? !next : wx == 0; });
      const auto layer = [&](int tilt, bool high) {
        return std::clamp(source.z + tilt_.layer(tilt, distance, high), 0, n_ - 1);
      };
      const Extent later = seen.tilts.none()
                               ? kNothing
                               : Extent{layer(seen.tilts.min, false), layer(seen.tilts.max, true)};
      outlooks[cell_number(x, y, n_)] = {all, later, seen.since + 3};
    });
  }
  return outlooks;
}

}  // namespace rc2::cycle
