// rc2_ray_queue against std::deque: order, count, the head as it was probed to, and probed until it
// leaves.
#include <deque>

#include "tb/rtl/ray_ports.h"

namespace {

constexpr std::size_t kDepth = 3;
// Of ray_t, what lies below along_y.
constexpr int kAlongY = 3 * 12 + rc2::tb::kHeightBits + rc2::tb::kApproachBits + 2 + 20 +
                        2 * rc2::tb::kShareBits + rc2::tb::kIndexBits + 3 * 2 + 2;

TEST(RayQueue, FollowsADequeUnderRandomTraffic) {
  rc2::tb::Clocked<Vtop> queue;
  rc2::tb::Dice dice(1);
  std::deque<std::vector<unsigned>> reference;
  bool is_probed = false;
  int full = 0, taken_unprobed = 0;
  const auto words = [&] {
    std::vector<unsigned> found(sizeof queue.top.data_i / sizeof(unsigned));
    for (unsigned& word : found) word = static_cast<unsigned>(dice.roll(0, 0x3fffffff));
    found.back() = 0;  // partly beyond a ray
    return found;
  };
  const auto put = [](auto& port, const std::vector<unsigned>& from) {
    std::copy(from.begin(), from.end(), port.data());
  };
  for (int cycle = 0; cycle < 100000; ++cycle) {
    queue.settle();
    ASSERT_EQ(queue.top.count_o, reference.size()) << "cycle " << cycle;
    ASSERT_EQ(queue.top.probed_o, is_probed) << "cycle " << cycle;
    if (!reference.empty()) {
      const std::vector<unsigned>& head = reference.front();
      for (std::size_t i = 0; i < head.size(); ++i)
        ASSERT_EQ(queue.top.data_o[i], head[i]) << "cycle " << cycle << " word " << i;
      ASSERT_EQ(queue.top.along_y_o, head[kAlongY / 32] >> kAlongY % 32 & 1) << "cycle " << cycle;
    }
    const int bias = (cycle / 1000) % 2 == 0 ? 70 : 30;  // fill it, then drain it
    const bool pop = !reference.empty() && dice.chance(100 - bias);
    const bool probe = !reference.empty() && !pop && !is_probed && dice.chance(50);
    const bool push = reference.size() < kDepth && dice.chance(bias);
    full += reference.size() == kDepth;
    taken_unprobed += pop && !is_probed;
    const std::vector<unsigned> word = words(), probed = words();
    queue.top.push_i = push;
    queue.top.pop_i = pop;
    queue.top.probe_i = probe;
    put(queue.top.data_i, word);
    put(queue.top.probe_data_i, probed);
    queue.tick();
    if (probe) reference.front() = probed;
    is_probed = !pop && (is_probed || probe);
    if (pop) reference.pop_front();
    if (push) reference.push_back(word);
  }
  EXPECT_GT(full, 100);
  EXPECT_GT(taken_unprobed, 100);
}

}  // namespace
