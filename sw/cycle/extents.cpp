#include "sw/cycle/extents.h"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <limits>
#include <utility>

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

using Ways = std::vector<std::pair<int, int>>;

// The light's own cell counts as one on its row.
bool wide_at(int dx, int dy) { return std::abs(dx) > std::abs(dy) || (dx == 0 && dy == 0); }

/// The ways outward to the sectors that a cell's sector is made of.
Ways outward(int dx, int dy) {
  const int x = dx < 0 ? -1 : 1, y = dy < 0 ? -1 : 1;
  const bool wide = wide_at(dx, dy), tall = std::abs(dy) > std::abs(dx);
  Ways ways{{x, y}};
  if (!tall) ways.emplace_back(x, 0);
  if (!wide) ways.emplace_back(0, y);
  if (wide && dy == 0) ways.emplace_back(x, -y);
  if (tall && dx == 0) ways.emplace_back(-x, y);
  return ways;
}

/// The ways outward within the ring, or to what is left of the eight neighbours.
Ways sideways(int dx, int dy) {
  const int x = dx < 0 ? -1 : 1, y = dy < 0 ? -1 : 1;
  const bool wide = wide_at(dx, dy), tall = std::abs(dy) > std::abs(dx);
  Ways ways;
  if (wide) ways.emplace_back(0, y);
  if (wide && dy == 0) ways.emplace_back(0, -y);
  if (tall) ways.emplace_back(x, 0);
  if (tall && dx == 0) ways.emplace_back(-x, 0);
  return ways;
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
  const auto join = [&](Sector& sector, int x, int y, const Ways& ways) {
    for (const auto& [wx, wy] : ways) {
      if (x + wx < 0 || y + wy < 0 || x + wx >= n_ || y + wy >= n_) continue;
      const Sector& other = sectors[cell_number(x + wx, y + wy, n_)];
      sector.tilts = joined(sector.tilts, other.tilts);
      sector.since = std::max(sector.since, other.since);
    }
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
      join(sector, x, y, outward(dx, dy));
      ++sector.since;
      if (distance == 0) {  // it has eight neighbours: those to the west come a cycle later
        join(sector, x, y, {{-1, 0}, {-1, 1}, {-1, -1}});
        ++sector.since;
      }
      sectors[cell_number(x, y, n_)] = sector;
    });
    ring(distance, [&](int x, int y, int dx, int dy) {
      if (!anything(x, y, source)) return;
      Sector seen = sectors[cell_number(x, y, n_)];
      join(seen, x, y, sideways(dx, dy));
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
