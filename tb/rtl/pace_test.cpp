// rc2_pace against what it says of each cycle: step and lane, where they are, and the ratios of the
// steps that come, for random lights of n = 16, some of which end early.
#include <algorithm>

#include "sw/machine/host_port.h"
#include "tb/rtl/block.h"

namespace {

constexpr int kN = 16, kLmax = 4 * kN;
constexpr int kCoordW = 4, kCountW = 5, kDistanceW = 7, kQueueW = 6, kRatioF = 11, kRatioW = 17;
constexpr int kSlopeW = 20, kSlopeF = 16;

/// The fields of pace_t, taken off from its low end.
struct Pace {
  explicit Pace(std::uint64_t word) : rest(word) {}
  std::uint64_t take(int width) {
    const std::uint64_t field = rest & ((1ULL << width) - 1);
    rest >>= width;
    return field;
  }
  std::uint64_t rest;
  std::uint64_t slope = take(kSlopeW), ratio = take(kRatioW), tell_step = take(kCountW);
  std::uint64_t tell = take(1), next_layer = take(kCoordW), last = take(1), on = take(1);
  std::uint64_t step = take(kCountW), first = take(1), active = take(1);
};

// L/2k is less than two units too large (rc2_ratio).
void expect_ratio(std::uint64_t ratio, int distance, int k) {
  const std::int64_t error =
      static_cast<std::int64_t>(ratio) * 2 * k - (std::int64_t{distance} << kRatioF);
  ASSERT_GE(error, 0) << "L/2k, k " << k;
  ASSERT_LT(error, 2 * 2 * k) << "L/2k, k " << k;
}

TEST(PaceOfLight, TellsStepsAndRatios) {
  rc2::MachineConfig config;
  config.n = kN;
  config.max_distance = kLmax;
  rc2::tb::Clocked<Vtop> pace;
  rc2::tb::Dice dice(10);
  const auto pick = [&](int low, int high) { return static_cast<int>(dice.roll(low, high)); };
  for (int light = 0; light < 3000 && !testing::Test::HasFatalFailure(); ++light) {
    const int xs = pick(0, kN - 1), ys = pick(0, kN - 1), zs = pick(0, kN - 1);
    const int distance = pick(1, kLmax);
    const std::uint64_t inverse = rc2::host_port::inverse_of(distance, rc2::inverse_bits(config));
    SCOPED_TRACE(testing::Message()
                 << "light " << xs << "," << ys << "," << zs << " L " << distance);
    pace.top.light_i = inverse << (3 * kCoordW + kDistanceW + kQueueW) |
                       static_cast<std::uint64_t>(xs) << (2 * kCoordW + kDistanceW + kQueueW) |
                       static_cast<std::uint64_t>(ys) << (kCoordW + kDistanceW + kQueueW) |
                       static_cast<std::uint64_t>(zs) << (kDistanceW + kQueueW) |
                       static_cast<std::uint64_t>(distance) << kQueueW | 8;
    int farthest = 0;
    for (const int s : {xs, ys, zs}) farthest = std::max({farthest, s, kN - 1 - s});
    const int idle_from = dice.chance(50) ? pick(0, farthest) : farthest + 1;
    const int steps = std::min(farthest, std::max(idle_from, 1)) + 1;
    // Between lights the array is idle, and nothing moves.
    pace.top.idle_i = 1;
    for (int i = pick(4, 6); i > 0; --i) {
      pace.settle();
      const Pace now(pace.top.pace_o);
      ASSERT_EQ(now.active + now.on + now.tell + pace.top.busy_o + pace.top.tick_o, 0U);
      pace.tick();
    }
    for (int cycle = 0; cycle <= 2 * steps; ++cycle) {
      SCOPED_TRACE("cycle " + std::to_string(cycle));
      const bool starts = cycle == 0;
      const int step = (cycle - 1) / 2;
      const bool first = cycle % 2 == 1;
      pace.top.start_i = starts;
      pace.top.idle_i = !starts && (step >= idle_from || (!first && step == 0 && dice.chance(50)) ||
                                    (first && dice.chance(50)));
      pace.settle();
      const Pace now(pace.top.pace_o);
      ASSERT_EQ(now.active, starts ? 0U : 1U);
      ASSERT_EQ(pace.top.busy_o, now.active);
      ASSERT_EQ(pace.top.tick_o, starts || !first ? 1 : 0);
      ASSERT_EQ(now.tell, starts || first ? 1U : 0U);
      const int next_step = cycle / 2;
      const bool next_up = cycle % 2 == 0;
      ASSERT_EQ(now.next_layer, rc2::tb::bits(next_up ? zs + next_step : zs - next_step, kCoordW));
      if (now.tell != 0) {
        const int k = starts ? 1 : step + 2;
        ASSERT_EQ(now.tell_step, static_cast<unsigned>(k));
        if (k < kN) {
          ASSERT_NO_FATAL_FAILURE(expect_ratio(now.ratio, distance, k));
          const std::int64_t slope = static_cast<std::int64_t>(now.slope) * distance;
          ASSERT_LE(slope, std::int64_t{k} << kSlopeF);
          ASSERT_GT(slope + 2 * distance, std::int64_t{k} << kSlopeF);
        }
      }
      if (!starts) {
        const int room = first ? kN - 1 - zs : zs;
        ASSERT_EQ(now.first, first ? 1U : 0U);
        ASSERT_EQ(now.step, static_cast<unsigned>(step));
        ASSERT_EQ(now.on, step <= room ? 1U : 0U);
        ASSERT_EQ(now.last, step == room ? 1U : 0U);
        if (step + 3 <= kN) {
          ASSERT_NO_FATAL_FAILURE(expect_ratio(pace.top.ratio_o, distance, step + 3));
        }
      }
      pace.tick();
    }
  }
}

}  // namespace
