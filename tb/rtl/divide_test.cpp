// rc2_divide against the processor's division: any numbers, in as many cycles as its step asks for.
#include <algorithm>

#include "tb/rtl/block.h"

namespace {

constexpr int kNumBits = 20, kDivBits = 9, kQuotBits = 12;
constexpr int kCycles = (kQuotBits + RC2_STEP - 1) / RC2_STEP;

TEST(Divide, IsTheQuotientOrAllOnes) {
  rc2::tb::Clocked<Vtop> divide;
  rc2::tb::Dice dice(1);
  for (int i = 0; i < 20000; ++i) {
    auto num = static_cast<unsigned>(dice.roll_size((1 << kNumBits) - 1) - 1);
    const auto by = static_cast<unsigned>(dice.roll_size((1 << kDivBits) - 1) - 1);
    // The first quotient that has too many bits, and the last that has not.
    if (dice.chance(10) && by < 1U << (kNumBits - kQuotBits)) num = (by << kQuotBits) - (i % 2);
    divide.top.num_i = num;
    divide.top.div_i = static_cast<SData>(by);
    divide.top.start_i = 1;
    divide.tick();
    divide.top.start_i = 0;
    divide.top.num_i = 0;
    divide.top.div_i = 0;
    int cycles = 1;
    for (; divide.top.done_o == 0; ++cycles) divide.tick();
    divide.tick();
    ASSERT_EQ(cycles, kCycles);
    constexpr unsigned kMost = (1U << kQuotBits) - 1;
    const unsigned exact = by == 0 ? kMost + 1 : num / by;
    ASSERT_EQ(divide.top.quot_o, std::min(kMost, exact)) << num << " / " << by;
    if (exact <= kMost) {
      ASSERT_EQ(divide.top.rest_o, num % by != 0) << num << " / " << by;
    }
    // It stays.
    for (int wait = i % 4; wait > 0; --wait) {
      divide.tick();
      ASSERT_EQ(divide.top.done_o, 0);
      ASSERT_EQ(divide.top.quot_o, std::min(kMost, exact)) << num << " / " << by;
    }
  }
}

}  // namespace
