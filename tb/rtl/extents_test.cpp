// rc2_extents against the lowest and highest of all that it has heard, for random fills, random
// neighbours and every place of the cell seen from the light.
#include <algorithm>
#include <array>

#include "tb/rtl/block.h"

namespace {

constexpr int kN = 8, kCoordW = 3;

struct Extent {
  int min = kN - 1, max = 0;
  void join(Extent other) {
    min = std::min(min, other.min);
    max = std::max(max, other.max);
  }
  std::uint64_t packed() const { return static_cast<std::uint64_t>(max << kCoordW | min); }
};

enum Quadrant { kNe, kNw, kSw, kSe };

/// The quadrants away from a light that is `dx`, `dy` to the west and south of the cell.
Extent away(const std::array<Extent, 4>& quadrants, int dx, int dy) {
  Extent all;
  const auto take = [&](Quadrant quadrant, bool east, bool north) {
    if ((dx == 0 || (dx > 0) == east) && (dy == 0 || (dy > 0) == north))
      all.join(quadrants[quadrant]);
  };
  take(kNe, true, true);
  take(kNw, false, true);
  take(kSw, false, false);
  take(kSe, true, false);
  return all;
}

TEST(Extents, JoinTheOwnColumnWithWhatTheNeighboursTell) {
  rc2::tb::Clocked<Vtop> unit;
  rc2::tb::Dice dice(8);
  const auto pick = [&](int low, int high) { return static_cast<int>(dice.roll(low, high)); };
  for (int scene = 0; scene < 2000; ++scene) {
    unit.top.fill_i = 0;
    unit.top.clear_i = 1;
    unit.tick();
    unit.top.clear_i = 0;
    // Neighbours only ever learn more; here they begin with all they will know.
    std::array<Extent, 8> heard;
    for (Extent& extent : heard) {
      if (dice.chance(40)) continue;
      extent.min = pick(0, kN - 1);
      extent.max = pick(extent.min, kN - 1);
    }
    unit.top.ne_e_i = heard[0].packed();
    unit.top.ne_n_i = heard[1].packed();
    unit.top.nw_w_i = heard[2].packed();
    unit.top.nw_n_i = heard[3].packed();
    unit.top.sw_w_i = heard[4].packed();
    unit.top.sw_s_i = heard[5].packed();
    unit.top.se_e_i = heard[6].packed();
    unit.top.se_s_i = heard[7].packed();
    Extent own;
    for (int fills = pick(0, 3); fills > 0; --fills) {
      const int z = pick(0, kN - 1);
      own.join({z, z});
      unit.top.fill_i = 1;
      unit.top.fill_z_i = static_cast<CData>(z);
      unit.tick();
      unit.top.fill_i = 0;
      unit.top.fill_z_i = static_cast<CData>(pick(0, kN - 1));
      if (dice.chance(50)) unit.tick();
    }
    std::array<Extent, 4> quadrants;
    for (std::size_t q = 0; q < 4; ++q) {
      quadrants[q] = own;
      quadrants[q].join(heard[2 * q]);
      quadrants[q].join(heard[2 * q + 1]);
    }
    unit.tick();
    unit.tick();
    ASSERT_EQ(unit.top.ne_o, quadrants[kNe].packed());
    ASSERT_EQ(unit.top.nw_o, quadrants[kNw].packed());
    ASSERT_EQ(unit.top.sw_o, quadrants[kSw].packed());
    ASSERT_EQ(unit.top.se_o, quadrants[kSe].packed());
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        unit.top.east_i = dx > 0;
        unit.top.west_i = dx < 0;
        unit.top.north_i = dy > 0;
        unit.top.south_i = dy < 0;
        unit.tick();
        const Extent want = away(quadrants, dx, dy);
        ASSERT_EQ(unit.top.min_o, want.min) << "scene " << scene << " at " << dx << "," << dy;
        ASSERT_EQ(unit.top.max_o, want.max) << "scene " << scene << " at " << dx << "," << dy;
      }
    }
  }
}

}  // namespace
