// rc2_facet_stage against its definition: packets of random boxes among READ and DATA words, random
// stalls at the unit and at the next stage; both see exactly their words, in order, stepped.
#include <array>
#include <deque>

#include "sw/machine/host_word.h"
#include "tb/rtl/block.h"

namespace {

// Small enough for a word to fit in 64 bits.
constexpr rc2::MachineConfig kConfig{8, 1, 32, 32};
constexpr std::int64_t kStride = 4;

struct Packed {
  rc2::WordKind kind;
  std::uint64_t lead, rest;
};

class Stage : public testing::Test {
 protected:
  const rc2::WordFormat format{kConfig};
  rc2::tb::Clocked<Vtop> stage;
  rc2::tb::Dice dice{4};
  std::deque<Packed> to_unit, to_next;

  std::uint64_t pack(const Packed& word) const {
    const int payload = format.lead + format.rest;
    return static_cast<std::uint64_t>(word.kind) << payload | word.lead << format.rest | word.rest;
  }

  void tick(bool& taken) {
    stage.top.unit_ready_i = dice.chance(70);
    stage.top.next_ready_i = dice.chance(70);
    stage.settle();
    taken = stage.top.ready_o != 0;
    const bool unit = stage.top.unit_valid_o != 0 && stage.top.unit_ready_i != 0;
    ASSERT_GE(stage.top.unit_waits_o, stage.top.unit_valid_o);
    const bool next = stage.top.next_valid_o != 0 && stage.top.next_ready_i != 0;
    if (unit) {
      ASSERT_FALSE(to_unit.empty());
      const Packed want = to_unit.front();
      to_unit.pop_front();
      ASSERT_EQ(stage.top.unit_word_o,
                static_cast<std::uint64_t>(want.kind) << format.rest | want.rest);
    }
    if (next) {
      ASSERT_FALSE(to_next.empty());
      ASSERT_EQ(stage.top.next_word_o, pack(to_next.front()));
      to_next.pop_front();
    }
    stage.tick();
  }

  void send(const Packed& word) {
    stage.top.valid_i = 1;
    stage.top.word_i = pack(word);
    bool taken = false;
    for (int waited = 0; !taken && !HasFatalFailure(); ++waited) {
      ASSERT_LT(waited, 1000) << "it hangs";
      tick(taken);
    }
    stage.top.valid_i = 0;
  }

  std::uint64_t random_bits(int width) { return dice.bits() >> (64 - width); }
};

TEST_F(Stage, WalksPacketsPastItsUnit) {
  for (int packet = 0; packet < 5000 && !HasFatalFailure(); ++packet) {
    if (dice.chance(10)) {
      const Packed read{rc2::WordKind::read, 0, random_bits(2)};
      to_unit.push_back(read);
      to_next.push_back(read);
      send(read);
    } else if (dice.chance(10)) {
      const Packed data{rc2::WordKind::data, random_bits(format.lead), random_bits(format.rest)};
      to_next.push_back(data);
      send(data);
    } else {
      const auto skip = static_cast<std::uint64_t>(dice.roll(0, 3));
      const auto take = static_cast<std::uint64_t>(dice.roll(1, 3));
      const bool here = skip == 0;
      const bool on = skip != 0 || take > 1;
      const auto steer = [&](std::uint64_t s, std::uint64_t t) { return t << format.count | s; };
      Packed head{rc2::WordKind::head, steer(skip, take), random_bits(format.rest)};
      if (here) to_unit.push_back(head);
      if (on) {
        Packed next = head;
        next.lead = here ? steer(0, take - 1) : steer(skip - 1, take);
        to_next.push_back(next);
      }
      send(head);
      constexpr std::array kKinds{rc2::WordKind::slab, rc2::WordKind::side, rc2::WordKind::gap};
      for (const rc2::WordKind kind : kKinds) {
        const std::int64_t step = dice.roll(-500, 500);
        const std::int64_t d = dice.roll(-6000, 6000);
        const std::uint64_t above = random_bits(format.rest - format.offset) << format.offset;
        const Packed value{kind, rc2::tb::bits(step, format.lead),
                           above | rc2::tb::bits(d, format.offset)};
        if (here) to_unit.push_back(value);
        if (on) {
          Packed next = value;
          if (here) next.rest = above | rc2::tb::bits(d + kStride * step, format.offset);
          to_next.push_back(next);
        }
        send(value);
      }
    }
  }
  for (int i = 0; i < 100; ++i) {
    bool ignored = false;
    tick(ignored);
  }
  EXPECT_TRUE(to_unit.empty());
  EXPECT_TRUE(to_next.empty());
}

}  // namespace
