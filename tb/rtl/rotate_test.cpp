// rc2_rotate: one grant to somebody who asks, and nobody waits for more than the others once.
#include <array>
#include <bitset>

#include "tb/rtl/block.h"

namespace {

constexpr int kWays = 9;

TEST(Rotate, GrantsOneWhoAsksAndNobodyWaitsLong) {
  rc2::tb::Clocked<Vtop> arbiter;
  rc2::tb::Dice dice(2);
  std::array<int, kWays> waited{};
  for (int cycle = 0; cycle < 100000; ++cycle) {
    // Who has asked goes on asking until it is served.
    unsigned request =
        static_cast<unsigned>(dice.roll(0, (1 << kWays) - 1) & dice.roll(0, (1 << kWays) - 1));
    for (int way = 0; way < kWays; ++way) {
      if (waited[static_cast<std::size_t>(way)] > 0) request |= 1U << way;
    }
    arbiter.top.request_i = request;
    arbiter.top.take_i = dice.chance(80);
    arbiter.settle();
    const unsigned grant = arbiter.top.grant_o;
    ASSERT_EQ(std::bitset<kWays>(grant).count(), request != 0 ? 1U : 0U);
    ASSERT_EQ(grant & ~request, 0U);
    for (int way = 0; way < kWays; ++way) {
      auto& turns = waited[static_cast<std::size_t>(way)];
      if ((request >> way & 1U) == 0) continue;
      if (arbiter.top.take_i != 0) turns = (grant >> way & 1U) != 0 ? 0 : turns + 1;
      ASSERT_LT(turns, kWays) << "way " << way << " starves";
    }
    arbiter.tick();
  }
}

}  // namespace
