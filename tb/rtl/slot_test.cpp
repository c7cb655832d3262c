// rc2_slot against what a buffer of one word is, under random traffic.
#include <optional>

#include "tb/rtl/block.h"

namespace {

TEST(Slot, HoldsOneWordUntilItIsTaken) {
  rc2::tb::Clocked<Vtop> slot;
  rc2::tb::Dice dice(6);
  std::optional<int> held;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const bool offered = dice.chance(60);
    const int word = static_cast<int>(dice.roll(0, 255));
    const bool taken = held.has_value() && dice.chance(40);
    slot.top.valid_i = offered;
    slot.top.data_i = static_cast<CData>(word);
    slot.top.take_i = taken;
    slot.settle();
    ASSERT_EQ(slot.top.ready_o, held.has_value() ? 0 : 1);
    ASSERT_EQ(slot.top.valid_o, held.has_value() ? 1 : 0);
    if (held.has_value()) {
      ASSERT_EQ(slot.top.data_o, *held);
    }
    slot.tick();
    if (taken) {
      held.reset();
    } else if (!held.has_value() && offered) {
      held = word;
    }
  }
}

}  // namespace
