// rc2_stops against the rays themselves (nearest integer to v*k/L, ties down), target by target,
// for random columns of n = 16, lights, distances, steps and beams, more runs than the table has
// among them.
#include <algorithm>
#include <vector>

#include "tb/rtl/block.h"

namespace {

constexpr int kN = 16, kLmax = 4 * kN, kRuns = 6;
constexpr int kTargetW = 8, kStopW = 9, kRatioF = 11, kSlopeF = 16;

int floor_div(int a, int b) { return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0); }

/// One light that comes to one column, k >= 1 steps away.
struct Visit {
  unsigned stops;
  int zs, k, distance, low, high;
  bool beyond;

  int voxel(int target) const { return zs - floor_div(distance - 2 * target * k, 2 * distance); }
  bool stopped(int target) const {
    const int z = voxel(target);
    return z >= 0 && z < kN && (stops >> z & 1U) != 0;
  }
  // Layers that are worth while and that rays can be in.
  int first() const { return std::max(zs - k, low); }
  int last() const { return std::min(zs + k, high); }
  /// Runs of stops that are found from voxel `from` on.
  int runs(int from) const {
    int found = 0;
    for (int z = from; z <= last(); ++z) {
      const bool here = (stops >> z & 1U) != 0;
      found += here && (z == from || (stops >> (z - 1) & 1U) == 0) ? 1 : 0;
    }
    return found;
  }
};

class Stops : public testing::Test {
 protected:
  int pick(int low, int high) { return static_cast<int>(dice.roll(low, high)); }

  static int number(unsigned bits, int width) {
    return static_cast<int>(bits) - (static_cast<int>(bits >> (width - 1)) << width);
  }

  Visit draw() {
    Visit v{};
    v.stops = static_cast<unsigned>(pick(0, 65535));
    if (dice.chance(50)) v.stops &= static_cast<unsigned>(pick(0, 65535));
    if (dice.chance(20)) v.stops = 0x5555U << pick(0, 1);
    v.zs = pick(0, kN - 1);
    v.k = pick(1, kN - 1);
    v.distance = pick(1, kLmax);
    v.low = pick(0, kN - 1);
    v.high = pick(v.low, kN - 1);
    if (dice.chance(50)) v.low = 0, v.high = kN - 1;
    v.beyond = dice.chance(95);
    return v;
  }

  /// Tells the unit of the light, in time and then that it has come.
  void come(const Visit& v) {
    unit.top.start_i = 1;
    unit.top.step_i = static_cast<CData>(v.k);
    unit.top.zs_i = static_cast<CData>(v.zs);
    unit.top.distance_i = static_cast<CData>(v.distance);
    unit.top.stops_i = static_cast<SData>(v.stops);
    tell_layers(dice.chance(50), pick(0, kN - 1), pick(0, kN - 1));
    unit.tick();
    unit.top.start_i = 0;
    expect_no_answer();
    tell_layers(v.beyond, v.low, v.high);
    unit.tick();
    // From here on another light's layers would do as well.
    tell_layers(dice.chance(50), pick(0, kN - 1), pick(0, kN - 1));
    unit.top.set_i = 1;
    unit.top.ratio_i = static_cast<IData>(((v.distance << kRatioF) + 2 * v.k - 1) / (2 * v.k));
    unit.top.slope_i = static_cast<IData>((v.k << kSlopeF) / v.distance);
    unit.tick();
    unit.top.set_i = 0;
    unit.top.ratio_i = static_cast<IData>(pick(0, 1 << 16));
    unit.top.slope_i = static_cast<IData>(pick(0, 1 << 16));
  }

  void tell_layers(bool beyond, int low, int high) {
    unit.top.beyond_i = beyond;
    unit.top.low_i = static_cast<CData>(low);
    unit.top.high_i = static_cast<CData>(high);
  }

  /// Nothing is known until a light has come.
  void expect_no_answer() {
    ask(0, 0);
    ASSERT_EQ(unit.top.known_o, 0);
    unit.top.ask_i = 0;
  }

  void reset() {
    unit.top.rst_ni = 0;
    unit.tick();
    unit.top.rst_ni = 1;
    unit.settle();
    ASSERT_EQ(unit.top.busy_o, 0);
    expect_no_answer();
  }

  void ask(int min, int max) {
    unit.top.ask_i = 1;
    unit.top.min_i = static_cast<CData>(rc2::tb::bits(min, kTargetW));
    unit.top.max_i = static_cast<CData>(rc2::tb::bits(max, kTargetW));
    unit.settle();
  }

  /// Lets the targets min .. max of the light pass, one interval after another.
  void pass(const Visit& v, int min, int max) {
    while (min <= max) {
      ask(min, max);
      // A miss fills the table from the voxel of the beam's first target.
      if (unit.top.known_o == 0) {
        ++misses;
        const int wait = 4 + std::min(v.runs(v.voxel(min)), kRuns);
        for (int i = 0; i < wait; ++i) {
          ASSERT_EQ(unit.top.known_o, 0) << "cycle " << i << " of a miss";
          unit.tick();
        }
        ASSERT_NE(unit.top.known_o, 0) << "not known after a miss";
      }
      const int free_min = number(unit.top.free_min_o, kStopW);
      const int free_max = number(unit.top.free_max_o, kStopW);
      const int end = number(unit.top.end_o, kStopW);
      ASSERT_GE(end, min);
      ASSERT_LE(end, max);
      for (int target = min; target <= end; ++target) {
        ASSERT_EQ(v.stopped(target), target < free_min || target > free_max) << "target " << target;
      }
      unit.top.mark_i = 1;
      unit.tick();
      unit.top.mark_i = 0;
      // The next beam may be there by now.
      unit.top.ask_i = 0;
      unit.top.min_i = static_cast<CData>(pick(0, 255));
      unit.top.max_i = static_cast<CData>(pick(0, 255));
      ASSERT_EQ(unit.top.busy_o, 1);
      ASSERT_EQ(unit.top.marks_o, 0);
      unit.tick();
      unsigned marks = 0;
      for (int z = v.voxel(min); z <= v.voxel(end); ++z) marks |= 1U << z;
      ASSERT_EQ(unit.top.marks_o, marks) << min << " .. " << end;
      ASSERT_EQ(unit.top.busy_o, 1);
      min = end + 1;
    }
  }

  rc2::tb::Clocked<Vtop> unit;
  rc2::tb::Dice dice{9};
  int misses = 0;
};

TEST_F(Stops, EndTheRaysThatMeetThem) {
  for (int round = 0; round < 20000 && !HasFatalFailure(); ++round) {
    const Visit v = draw();
    SCOPED_TRACE(testing::Message()
                 << "round " << round << " stops " << v.stops << " zs " << v.zs << " k " << v.k
                 << " L " << v.distance << " layers " << v.low << ".." << v.high);
    come(v);
    // All targets whose rays are in the layers that are worth while.
    std::vector<int> here;
    for (int target = -v.distance; target <= v.distance; ++target) {
      const int z = v.voxel(target);
      if (v.beyond && z >= std::max(v.first(), 0) && z <= v.last()) here.push_back(target);
    }
    // The table is there three cycles after set_i, and one more for each run in it.
    const int wait = 2 + std::min(v.runs(std::max(v.first(), 0)), kRuns);
    unit.top.ask_i = 0;
    for (int i = 0; i < wait; ++i) {
      if (!here.empty()) {
        ask(here.front(), here.front());
        ASSERT_EQ(unit.top.known_o, 0) << "cycle " << i;
      }
      unit.tick();
    }
    if (here.empty()) {
      ASSERT_GT(number(unit.top.clip_min_o, kStopW), number(unit.top.clip_max_o, kStopW));
      continue;
    }
    ask(here.front(), here.front());
    // The runs in the table may all lie below the first target.
    if (v.runs(std::max(v.first(), 0)) <= kRuns) {
      ASSERT_NE(unit.top.known_o, 0);
    }
    ASSERT_EQ(number(unit.top.clip_min_o, kStopW), here.front());
    ASSERT_EQ(number(unit.top.clip_max_o, kStopW), here.back());
    for (int beams = pick(1, 3); beams > 0; --beams) {
      const int min = pick(here.front(), here.back());
      ASSERT_NO_FATAL_FAILURE(pass(v, dice.chance(30) ? here.front() : min,
                                   dice.chance(30) ? here.back() : pick(min, here.back())));
      ASSERT_EQ(number(unit.top.clip_min_o, kStopW), here.front());
      ASSERT_EQ(number(unit.top.clip_max_o, kStopW), here.back());
    }
    if (dice.chance(10)) {
      unit.top.mark_i = 1;
      for (int i = pick(1, 2); i > 0; --i) unit.tick();
      unit.top.mark_i = 0;
      ASSERT_NO_FATAL_FAILURE(reset());
    }
    unit.top.ask_i = 0;
    unit.tick();
    ASSERT_EQ(unit.top.busy_o, 0);
    ASSERT_EQ(unit.top.marks_o, 0);
  }
  EXPECT_GT(misses, 100);
}

}  // namespace
