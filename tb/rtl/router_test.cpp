// rc2_router against what links are: each direction keeps its beams in order and loses none,
// arrivals are chosen in turn, the light's six beams among them, and a child leaves in the
// direction of its parts. Random beams, splits and stalls.
#include <array>
#include <deque>
#include <optional>

#include "tb/rtl/block.h"

namespace {

// n = 4, L up to 16.
constexpr int kCoordW = 2, kTargetW = 6, kDistanceW = 5, kQueueW = 6;
constexpr std::size_t kLinks = 8, kSource = 8, kInputs = 9;
// Parts {low, middle, high} of x and y that lie in direction d: E, NE, N, NW, W, SW, S, SE.
constexpr std::array<int, kLinks> kXPart{2, 2, 1, 0, 0, 0, 1, 2};
constexpr std::array<int, kLinks> kYPart{1, 2, 2, 2, 1, 0, 0, 0};

class Router : public testing::Test {
 protected:
  std::uint32_t random_bits(int width) {
    return static_cast<std::uint32_t>(dice.roll(0, (1LL << width) - 1));
  }

  /// Beams as they lie in the pins, target fields from the top.
  static std::uint32_t beam(std::uint32_t dir, std::uint32_t z,
                            std::array<std::uint32_t, 4> targets) {
    std::uint32_t bits = dir << kCoordW | z;
    for (const std::uint32_t target : targets) bits = bits << kTargetW | target;
    return bits;
  }

  /// The six beams of the light in their order (rc2_source).
  static std::deque<std::uint32_t> light_beams(std::uint32_t zs, int distance) {
    std::deque<std::uint32_t> beams;
    for (std::uint32_t dir = 0; dir < 6; ++dir) {
      const int u = dir < 2 ? distance : distance - 1, v = dir < 4 ? distance : distance - 1;
      const auto target = [](int t) {
        return static_cast<std::uint32_t>(rc2::tb::bits(t, kTargetW));
      };
      beams.push_back(beam(dir, zs, {target(-u), target(u), target(-v), target(v)}));
    }
    return beams;
  }

  /// A split with random parts; the child of direction d.
  struct Split {
    std::uint32_t dir, z;
    std::array<std::uint32_t, 12> parts;  // u low min, max, middle, high; then v
    std::uint32_t child(std::size_t d) const {
      const auto part = [&](int of_v, int which) {
        return static_cast<std::size_t>(6 * of_v + 2 * which);
      };
      const std::size_t u = part(0, dir < 2 ? kYPart[d] : kXPart[d]), v = part(1, kYPart[d]);
      return beam(dir, z, {parts[u], parts[u + 1], parts[v], parts[v + 1]});
    }
  };

  Split draw_split() {
    Split split{random_bits(1) | random_bits(1) << 1, random_bits(kCoordW), {}};
    if (dice.chance(40)) split.dir = 4 | random_bits(1);
    for (auto& part : split.parts) part = random_bits(kTargetW);
    std::array<std::uint32_t, 3> limbs{};
    int at = 0;
    const auto put = [&](std::uint32_t value, int width) {
      for (int bit = 0; bit < width; ++bit, ++at)
        limbs[static_cast<std::size_t>(at / 32)] |= (value >> bit & 1U) << (at % 32);
    };
    for (std::size_t i = split.parts.size(); i-- > 0;) put(split.parts[i], kTargetW);
    put(split.z, kCoordW);
    put(split.dir, 3);
    for (std::size_t i = 0; i < limbs.size(); ++i) router.top.split_i[i] = limbs[i];
    return split;
  }

  void offer(std::size_t d, std::uint32_t bits) {
    const std::array<IData*, kLinks> pins{
        &router.top.link0_i, &router.top.link1_i, &router.top.link2_i, &router.top.link3_i,
        &router.top.link4_i, &router.top.link5_i, &router.top.link6_i, &router.top.link7_i};
    *pins[d] = bits;
  }

  std::uint32_t on_link(std::size_t d) const {
    const std::array<IData, kLinks> pins{router.top.link0_o, router.top.link1_o, router.top.link2_o,
                                         router.top.link3_o, router.top.link4_o, router.top.link5_o,
                                         router.top.link6_o, router.top.link7_o};
    return pins[d];
  }

  rc2::tb::Clocked<Vtop> router;
  rc2::tb::Dice dice{13};
};

TEST_F(Router, KeepsOrderChoosesInTurnAndLosesNothing) {
  for (int light = 0; light < 300 && !HasFatalFailure(); ++light) {
    const std::uint32_t xs = random_bits(kCoordW), ys = random_bits(kCoordW),
                        zs = random_bits(kCoordW);
    const int distance = static_cast<int>(dice.roll(1, 16));
    const bool here = dice.chance(60);
    router.top.x_i = static_cast<CData>(here ? xs : xs ^ 1U);
    router.top.y_i = static_cast<CData>(here || dice.chance(50) ? ys : ys ^ 1U);
    router.top.light_i = xs << (2 * kCoordW + kDistanceW + kQueueW) |
                         ys << (kCoordW + kDistanceW + kQueueW) | zs << (kDistanceW + kQueueW) |
                         static_cast<std::uint32_t>(distance) << kQueueW | 4U;
    router.top.link_valid_i = 0;
    router.top.send_i = 0;
    router.top.arrival_take_i = 0;
    router.top.start_i = 1;
    router.tick();
    router.top.start_i = 0;

    std::array<std::deque<std::uint32_t>, kInputs> waiting;  // of a link at most one
    if (here) waiting[kSource] = light_beams(zs, distance);
    std::array<std::optional<std::uint32_t>, kLinks> leaving;
    std::size_t turn = 0;  // who comes first
    const int traffic = static_cast<int>(dice.roll(0, 70)),
              hurry = static_cast<int>(dice.roll(10, 90));
    for (int cycle = 0; cycle < 200; ++cycle) {
      SCOPED_TRACE(testing::Message() << "light " << light << " cycle " << cycle);
      // The last cycles let everything out.
      const bool draining = cycle >= 150;
      unsigned valid = 0, ready = 0, send = 0;
      for (std::size_t d = 0; d < kLinks; ++d) {
        valid |= (!draining && dice.chance(traffic) ? 1U : 0U) << d;
        ready |= (draining || dice.chance(hurry) ? 1U : 0U) << d;
        const bool free = !leaving[d].has_value() || (ready >> d & 1U) != 0;
        send |= (!draining && free && dice.chance(30) ? 1U : 0U) << d;
      }
      std::array<std::uint32_t, kLinks> offered{};
      for (std::size_t d = 0; d < kLinks; ++d) offer(d, offered[d] = random_bits(29));
      const Split split = draw_split();
      router.top.link_valid_i = static_cast<CData>(valid);
      router.top.link_ready_i = static_cast<CData>(ready);
      router.top.send_i = static_cast<CData>(send);
      router.top.arrival_take_i = 0;
      router.settle();
      std::size_t chosen = kInputs;
      bool busy = false;
      for (std::size_t i = 0; i < kInputs; ++i) {
        const std::size_t way = (turn + i) % kInputs;
        if (!waiting[way].empty() && chosen == kInputs) chosen = way;
        busy = busy || !waiting[way].empty();
      }
      ASSERT_EQ(router.top.arrival_valid_o, chosen < kInputs ? 1 : 0);
      if (chosen < kInputs) {
        ASSERT_EQ(router.top.arrival_o, waiting[chosen].front()) << "way " << chosen;
      }
      const bool take = chosen < kInputs && (draining || dice.chance(60));
      router.top.arrival_take_i = take;
      router.settle();
      for (std::size_t d = 0; d < kLinks; ++d) {
        const bool is_ready = (ready >> d & 1U) != 0;
        ASSERT_EQ(router.top.link_ready_o >> d & 1, waiting[d].empty() ? 1 : 0) << "from " << d;
        ASSERT_EQ(router.top.writable_o >> d & 1, !leaving[d].has_value() || is_ready ? 1 : 0)
            << "to " << d;
        ASSERT_EQ(router.top.link_valid_o >> d & 1, leaving[d].has_value() ? 1 : 0) << "to " << d;
        if (leaving[d].has_value()) {
          ASSERT_EQ(on_link(d), *leaving[d]) << "to " << d;
        }
        busy = busy || leaving[d].has_value();
      }
      ASSERT_EQ(router.top.busy_o, busy ? 1 : 0);
      router.tick();
      for (std::size_t d = 0; d < kLinks; ++d) {
        const bool room = waiting[d].empty();
        if (leaving[d].has_value() && (ready >> d & 1U) != 0) leaving[d].reset();
        if ((send >> d & 1U) != 0) leaving[d] = split.child(d);
        if (room && (valid >> d & 1U) != 0) waiting[d].push_back(offered[d]);
      }
      if (take) {
        waiting[chosen].pop_front();
        turn = (chosen + 1) % kInputs;
      }
    }
    for (const auto& beams : waiting) ASSERT_TRUE(beams.empty());
    ASSERT_EQ(router.top.busy_o, 0);
  }
}

}  // namespace
