// rc2_collector against what a row's end says: its own words, then those from above with their end;
// random stalls on all three streams.
#include <algorithm>
#include <deque>

#include "sw/machine/host_word.h"
#include "tb/rtl/block.h"

namespace {

constexpr rc2::MachineConfig kConfig{4, 4, 16, 32};

/// A word as far as the collector knows it: its kind, and a number to tell it by.
struct Token {
  rc2::WordKind kind;
  std::uint32_t number;
};

TEST(Collector, GivesTheRowThenThoseAbove) {
  const rc2::WordFormat format(kConfig);
  rc2::tb::Clocked<Vtop> unit;
  rc2::tb::Dice dice(12);
  std::uint32_t number = 0;
  const auto packed = [&](const Token& token) {
    return static_cast<QData>(token.kind) << (format.lead + format.rest) | token.number;
  };
  const auto words = [&](bool ends_of_objects) {
    std::deque<Token> stream;
    for (int i = static_cast<int>(dice.roll(0, 6)); i > 0; --i) {
      const bool drops = ends_of_objects && dice.chance(20);
      stream.push_back({drops ? rc2::WordKind::end : rc2::WordKind::data, ++number});
    }
    stream.push_back({rc2::WordKind::read, ++number});
    return stream;
  };
  for (int answer = 0; answer < 3000 && !testing::Test::HasFatalFailure(); ++answer) {
    std::deque<Token> row = words(true), above = words(false), expected;
    std::copy_if(row.begin(), row.end(), std::back_inserter(expected),
                 [](const Token& t) { return t.kind == rc2::WordKind::data; });
    std::copy(above.begin(), above.end(), std::back_inserter(expected));
    const int hurry = static_cast<int>(dice.roll(10, 95));
    unsigned held = 0;
    for (int cycle = 0; !expected.empty(); ++cycle) {
      ASSERT_LT(cycle, 1000) << "it hangs";
      const bool own_done = row.empty() && !above.empty();
      unit.top.row_valid_i = !row.empty() && dice.chance(60);
      unit.top.above_valid_i = !above.empty() && dice.chance(60);
      if (!row.empty()) unit.top.row_word_i = packed(row.front());
      if (!above.empty()) unit.top.above_word_i = packed(above.front());
      unit.top.ready_i = dice.chance(hurry);
      unit.settle();
      ASSERT_EQ(unit.top.row_ready_o, held < 2 && !own_done ? 1 : 0);
      ASSERT_EQ(unit.top.above_ready_o, held < 2 && own_done ? 1 : 0);
      ASSERT_EQ(unit.top.valid_o, held > 0 ? 1 : 0);
      ASSERT_EQ(unit.top.busy_o, held > 0 || own_done ? 1 : 0);
      const bool gives = unit.top.valid_o != 0 && unit.top.ready_i != 0;
      if (gives) {
        ASSERT_EQ(unit.top.word_o, packed(expected.front()));
        expected.pop_front();
      }
      const bool row_taken = unit.top.row_valid_i != 0 && unit.top.row_ready_o != 0;
      const bool above_taken = unit.top.above_valid_i != 0 && unit.top.above_ready_o != 0;
      unit.tick();
      held -= gives ? 1 : 0;
      held += above_taken || (row_taken && row.front().kind == rc2::WordKind::data) ? 1 : 0;
      if (row_taken) row.pop_front();
      if (above_taken) above.pop_front();
    }
    unit.top.row_valid_i = 0;
    unit.top.above_valid_i = 0;
    unit.settle();
    ASSERT_EQ(unit.top.busy_o, 0);
  }
}

}  // namespace
