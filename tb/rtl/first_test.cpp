// rc2_first of eleven bits, all words.
#include "tb/rtl/block.h"

namespace {

constexpr unsigned kWidth = 11;

TEST(First, IsTheLowestBitThatIsSet) {
  rc2::tb::Module<Vtop> first;
  for (unsigned word = 0; word < 1U << kWidth; ++word) {
    first.bits_i = static_cast<SData>(word);
    first.eval();
    unsigned lowest = 0;
    while (lowest < kWidth && (word >> lowest & 1U) == 0) ++lowest;
    ASSERT_EQ(first.found_o, word != 0) << word;
    ASSERT_EQ(first.index_o, word != 0 ? lowest : 0) << word;
  }
}

}  // namespace
