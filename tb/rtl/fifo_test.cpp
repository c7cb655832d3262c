// rc2_fifo against std::deque: order, count, a full queue that gives and takes in one cycle.
#include <deque>

#include "tb/rtl/block.h"

namespace {

constexpr std::size_t kDepth = 5;

TEST(Fifo, FollowsADequeUnderRandomTraffic) {
  rc2::tb::Clocked<Vtop> fifo;
  rc2::tb::Dice dice(1);
  std::deque<std::uint16_t> reference;
  int full_exchanges = 0;
  for (int cycle = 0; cycle < 100000; ++cycle) {
    fifo.settle();
    ASSERT_EQ(fifo.top.count_o, reference.size()) << "cycle " << cycle;
    if (!reference.empty()) {
      ASSERT_EQ(fifo.top.data_o, reference.front()) << "cycle " << cycle;
    }
    const int bias = (cycle / 1000) % 2 == 0 ? 70 : 30;  // fill it, then drain it
    const bool pop = !reference.empty() && dice.chance(100 - bias);
    const bool push = (reference.size() < kDepth || pop) && dice.chance(bias);
    const auto word = static_cast<std::uint16_t>(dice.roll(0, 65535));
    full_exchanges += (push && pop && reference.size() == kDepth) ? 1 : 0;
    fifo.top.push_i = push;
    fifo.top.pop_i = pop;
    fifo.top.data_i = word;
    fifo.tick();
    if (pop) reference.pop_front();
    if (push) reference.push_back(word);
  }
  EXPECT_GT(full_exchanges, 100);
}

}  // namespace
