// rc2_extents, cycle by cycle, for random fills, random neighbours that know at random times, and
// every place of the cell seen from the light. Which neighbours count is worked out from where they
// are.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

#include "tb/rtl/block.h"

namespace {

constexpr int kN = 8, kCoordW = 3, kFraction = kCoordW + 1, kSizeW = kFraction + 3;
constexpr int kTiltW = kSizeW + 1, kMost = (1 << kSizeW) - 1;
constexpr int kDivided = 2 * ((kSizeW + 3) / 4) + 2;
constexpr int kWayX[8] = {1, 1, 0, -1, -1, -1, 0, 1}, kWayY[8] = {0, 1, 1, 1, 0, -1, -1, -1};

struct Tilts {
  int min = kMost, max = -kMost;
  void join(const Tilts& other) {
    min = std::min(min, other.min);
    max = std::max(max, other.max);
  }
};

struct Neighbour {
  Tilts tilts;
  int since = 0;
  std::uint64_t packed(int cycle) const {
    return static_cast<std::uint64_t>(cycle >= since) << 2 * kTiltW |
           rc2::tb::bits(tilts.max, kTiltW) << kTiltW | rc2::tb::bits(tilts.min, kTiltW);
  }
};

/// A bound on the tilts of rays at a voxel: (2 rise +- 1) / (2 distance -+ 1), outward.
int tilt_of(int rise, int distance, bool high) {
  const int below = high ? rise < 0 : rise <= 0;
  const bool away = below == 0 ? high : !high;
  const int upper = 2 * std::abs(rise) + (away ? 1 : -1), lower = 2 * distance + (away ? -1 : 1);
  int size = kMost;
  if (lower > 0) size = std::min((upper << kFraction) / lower + (away ? 1 : 0), kMost);
  return below != 0 ? -size : size;
}

/// A bound on the layers of rays of a tilt: half a voxel more than half (2 distance +- 1) tilts.
int layer_of(int zs, int tilt, int distance, bool high) {
  const bool away = high ? tilt >= 0 : tilt < 0;
  if (away && std::abs(tilt) == kMost) return high ? kN - 1 : 0;
  const int halves = std::max(2 * distance + (away ? 1 : -1), 0);
  const int twice = std::abs(tilt) * halves >> kFraction;
  const int layers = away ? (twice + 1) / 2 : twice / 2;
  return std::clamp(zs + (tilt < 0 ? -layers : layers), 0, kN - 1);
}

class ExtentsUnit : public testing::Test {
 protected:
  int pick(int low, int high) { return static_cast<int>(dice.roll(low, high)); }

  std::optional<std::pair<int, int>> load_column() {
    unit.top.start_i = 0;
    unit.top.active_i = 0;
    unit.top.clear_i = 1;
    unit.top.fill_i = 0;
    unit.top.e_i = unit.top.n_i = unit.top.w_i = unit.top.s_i = 3;
    unit.tick();
    EXPECT_EQ(unit.top.quadrants_o, 0);
    unit.top.clear_i = 0;
    std::optional<std::pair<int, int>> own;
    for (int fills = pick(0, 3); fills > 0; --fills) {
      const int z = pick(0, kN - 1);
      own = own ? std::pair{std::min(own->first, z), std::max(own->second, z)} : std::pair{z, z};
      unit.top.fill_i = 1;
      unit.top.fill_z_i = static_cast<CData>(z);
      unit.tick();
      unit.top.fill_i = 0;
      unit.top.fill_z_i = static_cast<CData>(pick(0, kN - 1));
      if (dice.chance(50)) unit.tick();
    }
    return own;
  }

  void tell_reaches(const std::array<Neighbour, 8>& neighbours, int cycle) {
    unit.top.reach0_i = static_cast<IData>(neighbours[0].packed(cycle));
    unit.top.reach1_i = static_cast<IData>(neighbours[1].packed(cycle));
    unit.top.reach2_i = static_cast<IData>(neighbours[2].packed(cycle));
    unit.top.reach3_i = static_cast<IData>(neighbours[3].packed(cycle));
    unit.top.reach4_i = static_cast<IData>(neighbours[4].packed(cycle));
    unit.top.reach5_i = static_cast<IData>(neighbours[5].packed(cycle));
    unit.top.reach6_i = static_cast<IData>(neighbours[6].packed(cycle));
    unit.top.reach7_i = static_cast<IData>(neighbours[7].packed(cycle));
  }

  rc2::tb::Clocked<Vtop> unit;
  rc2::tb::Dice dice{8};
};

TEST_F(ExtentsUnit, JoinsWhatItsSectorCanMeet) {
  for (int scene = 0; scene < 6000; ++scene) {
    SCOPED_TRACE(testing::Message() << "scene " << scene);
    const int dx = pick(1 - kN, kN - 1) * pick(0, 1),
              dy = dice.chance(25) ? dx : pick(1 - kN, kN - 1) * pick(0, 1);
    const int distance = std::max(std::abs(dx), std::abs(dy)), zs = pick(0, kN - 1);
    const auto own = load_column();

    // Bits se sw nw ne of what lies east, north, west and south of the cell.
    const int e = pick(0, 3) & pick(0, 3), n = pick(0, 3) & pick(0, 3), w = pick(0, 3) & pick(0, 3),
              s = pick(0, 3) & pick(0, 3);
    unit.top.e_i = static_cast<CData>(e);
    unit.top.n_i = static_cast<CData>(n);
    unit.top.w_i = static_cast<CData>(w);
    unit.top.s_i = static_cast<CData>(s);
    const bool ne = own || (e & 1) != 0 || (n & 1) != 0, nw = own || (w & 1) != 0 || (n & 2) != 0,
               sw = own || (w & 2) != 0 || (s & 1) != 0, se = own || (e & 2) != 0 || (s & 2) != 0;
    unit.tick();
    unit.tick();
    ASSERT_EQ(unit.top.quadrants_o, se << 3 | sw << 2 | nw << 1 | (ne ? 1 : 0));
    const bool anything = (ne && dx >= 0 && dy >= 0) || (nw && dx <= 0 && dy >= 0) ||
                          (sw && dx <= 0 && dy <= 0) || (se && dx >= 0 && dy <= 0);

    std::array<Neighbour, 8> neighbours;
    for (Neighbour& neighbour : neighbours) {
      if (dice.chance(30)) continue;
      neighbour.since = pick(0, 12);
      neighbour.tilts.min = pick(-kMost, kMost);
      neighbour.tilts.max = pick(neighbour.tilts.min, kMost);
      if (dice.chance(10)) neighbour.tilts.max = kMost;
    }

    // A neighbour counts if light goes on to it: on no axis back to its source.
    Tilts sector, seen;
    int known = own ? kDivided : 1;
    if (own) {
      sector.min = tilt_of(own->first - zs, distance, false);
      sector.max = tilt_of(own->second - zs, distance, true);
    }
    const auto join = [&](bool next_ring, auto counts) {
      for (std::size_t d = 0; d < 8; ++d) {
        const int x = dx + kWayX[d], y = dy + kWayY[d];
        const bool back = kWayX[d] * dx < 0 || kWayY[d] * dy < 0;
        const bool next = std::max(std::abs(x), std::abs(y)) > distance;
        if (back || next != next_ring || !counts(kWayX[d])) continue;
        seen.join(neighbours[d].tilts);
        known = std::max(known, neighbours[d].since);
      }
    };
    seen = sector;
    if (distance > 0) {
      join(true, [](int) { return true; });
      ++known;
      sector = seen;
    } else {  // eight neighbours, in three steps
      join(true, [](int x) { return x > 0; });
      ++known;
      join(true, [](int x) { return x < 0; });
      ++known;
      sector = seen;
      join(true, [](int x) { return x == 0; });
    }
    const int sector_known = distance > 0 ? known : -1;
    join(false, [](int) { return true; });

    unit.top.zs_i = static_cast<CData>(zs);
    unit.top.distance_i = static_cast<CData>(distance);
    unit.top.east_i = dx > 0;
    unit.top.west_i = dx < 0;
    unit.top.north_i = dy > 0;
    unit.top.south_i = dy < 0;
    unit.top.wide_i = std::abs(dx) > std::abs(dy);
    unit.top.tall_i = std::abs(dy) > std::abs(dx);
    const int ready = known + 3;
    const bool none = seen.min > seen.max;
    for (int cycle = 0; cycle < 30; ++cycle) {
      unit.top.start_i = cycle == 0;
      unit.top.active_i = cycle > 0;
      tell_reaches(neighbours, cycle);
      unit.settle();
      ASSERT_EQ(unit.top.beyond_o, anything && !(cycle >= ready && none)) << "cycle " << cycle;
      if (!none || cycle < ready) {
        ASSERT_EQ(unit.top.min_o, cycle < ready ? 0 : layer_of(zs, seen.min, distance, false))
            << "cycle " << cycle;
        ASSERT_EQ(unit.top.max_o, cycle < ready ? kN - 1 : layer_of(zs, seen.max, distance, true))
            << "cycle " << cycle;
      }
      if (!anything) {
        ASSERT_EQ(unit.top.reach_o, Neighbour{}.packed(0));
      } else if (distance > 0 && cycle > 0) {
        const bool knows = (unit.top.reach_o >> 2 * kTiltW) != 0;
        ASSERT_EQ(knows, cycle >= sector_known) << "cycle " << cycle;
        if (knows) {
          const Neighbour expected{sector, 0};
          ASSERT_EQ(unit.top.reach_o, expected.packed(0)) << "cycle " << cycle;
        }
      }
      unit.tick();
    }
  }
}

}  // namespace
