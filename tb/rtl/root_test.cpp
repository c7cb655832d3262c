// rc2_root: the largest number whose square is not too large.
#include "tb/rtl/block.h"

namespace {

TEST(Root, IsTheSquareRootRoundedDown) {
  constexpr int kBits = 16;
  rc2::tb::Clocked<Vtop> root;
  rc2::tb::Dice dice(1);
  for (int i = 0; i < 20000; ++i) {
    const auto some = static_cast<std::uint64_t>(dice.roll(0, (1 << kBits) - 1));
    const auto any = static_cast<std::uint64_t>(dice.roll_size((1LL << 2 * kBits) - 1));
    const std::uint64_t squares[] = {some * some, some * some - (some > 0 ? 1 : 0), any};
    const std::uint64_t square = squares[i % 3];
    root.top.square_i = static_cast<IData>(square);
    root.top.start_i = 1;
    root.tick();
    root.top.start_i = 0;
    int cycles = 1;
    for (; root.top.done_o == 0; ++cycles) root.tick();
    root.tick();
    ASSERT_EQ(cycles, (kBits + RC2_STEP - 1) / RC2_STEP);
    const std::uint64_t found = root.top.root_o;
    ASSERT_LE(found * found, square);
    ASSERT_GT((found + 1) * (found + 1), square);
    // It stays.
    for (int wait = i % 4; wait > 0; --wait) {
      root.tick();
      ASSERT_EQ(root.top.done_o, 0);
      ASSERT_EQ(root.top.root_o, found);
    }
  }
}

}  // namespace
