// rc2_z_lanes against its definition bit by bit: where each pair of classes goes, and what stops
// it, for random fronts, cuts, stops and extents of n = 8.
#include <array>

#include "tb/rtl/block.h"

namespace {

constexpr int kN = 8, kM = 4, kCoordW = 3, kCountW = 4, kClassW = 3;
constexpr int kLowPaceW = kCountW + 15 + 16;  // tell_step, ratio, slope

using Front = unsigned;  // bit i*kM + j

bool at(Front front, int i, int j) {
  return i >= 0 && j >= 0 && i < kM && j < kM && (front >> (i * kM + j) & 1U) != 0;
}

/// The front of which `holds(i, j)` says who is in it.
template <class Holds>
Front front_of(Holds holds) {
  Front front = 0;
  for (int i = 0; i < kM; ++i) {
    for (int j = 0; j < kM; ++j) front |= static_cast<Front>(holds(i, j) ? 1 : 0) << (i * kM + j);
  }
  return front;
}

struct Cut {
  int come, stay, leave;
  std::uint64_t packed() const {
    return static_cast<std::uint64_t>(come << (2 * kClassW) | stay << kClassW | leave) << 2;
  }
};

TEST(ZLanes, MoveEveryBitAsItsClassesGo) {
  rc2::tb::Clocked<Vtop> unit;
  rc2::tb::Dice dice(11);
  const auto pick = [&](int low, int high) { return static_cast<int>(dice.roll(low, high)); };
  const auto some = [&](int chance) {
    return dice.chance(chance) ? static_cast<Front>(pick(0, 65535)) : 0U;
  };
  int stopped = 0, dropped = 0, passed = 0;
  for (int light = 0; light < 4000 && !testing::Test::HasFatalFailure(); ++light) {
    SCOPED_TRACE("light " + std::to_string(light));
    const int zs = pick(0, kN - 1);
    const bool source = dice.chance(40);
    const auto stops = static_cast<unsigned>(pick(0, 255) & pick(0, 255) & pick(0, 255));
    const bool beyond = dice.chance(90);
    const int low = dice.chance(70) ? 0 : pick(0, kN - 1), high = pick(low, kN - 1);
    unit.top.source_i = source;
    unit.top.stops_i = static_cast<CData>(stops);
    unit.top.beyond_i = beyond;
    unit.top.min_i = static_cast<CData>(low);
    unit.top.max_i = static_cast<CData>(high);
    std::array<Front, 2> lanes{source ? 1U : 0U, source ? 1U : 0U};  // upwards, downwards
    const int steps = pick(1, kN);
    for (int cycle = 0; cycle <= 2 * steps; ++cycle) {
      SCOPED_TRACE("cycle " + std::to_string(cycle));
      const bool starts = cycle == 0;
      const int step = (cycle - 1) / 2, lane = (cycle - 1) % 2;
      const int room = lane == 0 ? kN - 1 - zs : zs;
      const bool on = !starts && step <= room, last = !starts && step == room;
      const int z = lane == 0 ? zs + step : zs - step;
      const int next_step = cycle / 2, next_lane = cycle % 2;
      const Cut u{pick(0, kM), pick(0, kM), pick(0, kM)}, v{pick(0, kM), pick(0, kM), pick(0, kM)};
      const Front x = some(30), y = some(30), xy = some(30);
      unit.top.start_i = starts;
      const std::uint64_t next_layer =
          rc2::tb::bits(next_lane == 0 ? zs + next_step : zs - next_step, kCoordW);
      const auto bit = [](bool value) { return static_cast<std::uint64_t>(value ? 1 : 0); };
      unit.top.pace_i = bit(!starts) << (kLowPaceW + 1 + kCoordW + 2 + kCountW + 1) |
                        bit(starts || lane == 0) << (kLowPaceW + 1 + kCoordW + 2 + kCountW) |
                        static_cast<std::uint64_t>(starts ? 0 : step)
                            << (kLowPaceW + 1 + kCoordW + 2) |
                        bit(on) << (kLowPaceW + 1 + kCoordW + 1) |
                        bit(last) << (kLowPaceW + 1 + kCoordW) | next_layer << (kLowPaceW + 1);
      unit.top.u_i = static_cast<SData>(u.packed());
      unit.top.v_i = static_cast<SData>(v.packed());
      unit.top.u_come_i = static_cast<CData>(u.come);
      unit.top.v_come_i = static_cast<CData>(v.come);
      unit.top.x_i = static_cast<SData>(x);
      unit.top.y_i = static_cast<SData>(y);
      unit.top.xy_i = static_cast<SData>(xy);
      unit.settle();
      if (starts) {
        unit.tick();
        continue;
      }
      Front& front = lanes[static_cast<std::size_t>(lane)];
      const bool any = on && front != 0;
      const bool worth = beyond && low <= z && z <= high;
      const bool stop = any && worth && (stops >> z & 1U) != 0;
      const bool passes = any && worth && !stop;
      ASSERT_EQ(unit.top.busy_o, lanes[0] != 0 || lanes[1] != 0 ? 1 : 0);
      ASSERT_EQ(unit.top.reached_o, any && worth ? 1 : 0);
      ASSERT_EQ(unit.top.dropped_o, any && !worth ? 1 : 0);
      ASSERT_EQ(unit.top.stopped_o, stop ? 1 : 0);
      if (any) {
        ASSERT_EQ(unit.top.front_o, front);
        ASSERT_EQ(unit.top.z_o, z);
      }
      stopped += stop ? 1 : 0;
      dropped += any && !worth ? 1 : 0;
      passed += passes ? 1 : 0;
      const Front gone = passes ? front : 0;
      const Front own =
          front_of([&](int i, int j) { return at(gone, i, j) && i < u.stay && j < v.stay; });
      ASSERT_EQ(unit.top.x_o,
                front_of([&](int i, int j) { return at(gone, i + u.leave, j) && j < v.stay; }));
      ASSERT_EQ(unit.top.y_o,
                front_of([&](int i, int j) { return at(gone, i, j + v.leave) && i < u.stay; }));
      ASSERT_EQ(unit.top.xy_o,
                front_of([&](int i, int j) { return at(gone, i + u.leave, j + v.leave); }));
      unit.tick();
      if (!on) continue;
      const Front next = front_of([&](int i, int j) {
        const bool from_x = i < u.come, from_y = j < v.come;
        return at(from_x ? (from_y ? xy : x) : (from_y ? y : own), from_x ? i : i - u.come,
                  from_y ? j : j - v.come);
      });
      front = last ? 0 : next;
    }
  }
  for (int power_on = 0; power_on < 20; ++power_on) {
    rc2::tb::Clocked<Vtop> fresh;
    fresh.settle();
    ASSERT_EQ(fresh.top.busy_o, 0);
  }
  EXPECT_GT(stopped, 500);
  EXPECT_GT(dropped, 500);
  EXPECT_GT(passed, 500);
}

}  // namespace
