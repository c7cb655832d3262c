// rc2_facet_stage against its definition: packets of random boxes among READ and DATA words, random
// stalls at the unit and at the next stage; both see exactly their words, in order, stepped.
#include <deque>

#include "sim/host_word.h"
#include "tb/rtl/block.h"

namespace {

constexpr rc2::MachineConfig kConfig{8, 4, 32, 32};

struct Word {
  bool last;
  int kind;
  std::uint64_t lead, rest;
};

class Stage : public testing::Test {
 protected:
  const rc2::WordFormat format{kConfig};
  rc2::tb::Clocked<Vtop> stage;
  rc2::tb::Random random{4};
  std::deque<Word> to_unit, to_next;

  std::uint64_t pack(const Word& word) const {
    const int payload = format.lead + format.rest;
    return static_cast<std::uint64_t>(word.last) << (payload + 2) |
           static_cast<std::uint64_t>(word.kind) << payload | word.lead << format.rest | word.rest;
  }

  void tick(bool& taken) {
    stage.top.unit_ready_i = random.chance(70);
    stage.top.next_ready_i = random.chance(70);
    stage.settle();
    taken = stage.top.ready_o != 0;
    const bool unit = stage.top.unit_valid_o != 0 && stage.top.unit_ready_i != 0;
    const bool next = stage.top.next_valid_o != 0 && stage.top.next_ready_i != 0;
    if (unit) {
      ASSERT_FALSE(to_unit.empty());
      const Word want = to_unit.front();
      to_unit.pop_front();
      ASSERT_EQ(stage.top.unit_word_o, static_cast<std::uint64_t>(want.last) << (format.rest + 2) |
                                           static_cast<std::uint64_t>(want.kind) << format.rest |
                                           want.rest);
    }
    if (next) {
      ASSERT_FALSE(to_next.empty());
      ASSERT_EQ(stage.top.next_word_o, pack(to_next.front()));
      to_next.pop_front();
    }
    stage.tick();
  }

  void send(const Word& word) {
    stage.top.valid_i = 1;
    stage.top.word_i = pack(word);
    for (bool taken = false; !taken && !HasFatalFailure();) tick(taken);
    stage.top.valid_i = 0;
  }

  std::uint64_t random_bits(int width) { return rc2::tb::bits(random.in(0, INT64_MAX), width); }
};

TEST_F(Stage, WalksPacketsPastItsUnit) {
  for (int packet = 0; packet < 5000 && !HasFatalFailure(); ++packet) {
    if (random.chance(10)) {
      const Word read{true, 2, 0, random_bits(2)};
      to_unit.push_back(read);
      to_next.push_back(read);
      send(read);
    } else if (random.chance(10)) {
      const Word data{random.chance(50), 3, random_bits(format.lead), random_bits(format.rest)};
      to_next.push_back(data);
      send(data);
    } else {
      const auto skip = static_cast<std::uint64_t>(random.in(0, 3));
      const auto take = static_cast<std::uint64_t>(random.in(1, 3));
      const bool here = skip == 0;
      const bool on = skip != 0 || take > 1;
      const auto steer = [&](std::uint64_t s, std::uint64_t t) { return t << format.count | s; };
      Word head{false, 0, steer(skip, take), random_bits(format.rest)};
      if (here) to_unit.push_back(head);
      if (on) {
        Word next = head;
        next.lead = here ? steer(0, take - 1) : steer(skip - 1, take);
        to_next.push_back(next);
      }
      send(head);
      const int bounds = static_cast<int>(random.in(1, 5));
      for (int i = 0; i < bounds; ++i) {
        const std::int64_t step = random.in(-1000, 1000);
        const std::int64_t d = random.in(-100000, 100000);
        const std::uint64_t c = random_bits(format.coefficient) << format.offset;
        const Word bound{i + 1 == bounds, 1, rc2::tb::bits(step, format.lead),
                         c | rc2::tb::bits(d, format.offset)};
        if (here) to_unit.push_back(bound);
        if (on) {
          Word next = bound;
          if (here) next.rest = c | rc2::tb::bits(d + step, format.offset);
          to_next.push_back(next);
        }
        send(bound);
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
