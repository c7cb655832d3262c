// rc2_border against the division it replaces, for every border that rays can meet in n = 16, with
// the smallest and the largest ratio that rc2_ratio may give.
#include "sw/base/floor_divide.h"
#include "tb/rtl/block.h"

namespace {

TEST(Border, IsTheLastTargetBelow) {
  constexpr int kN = 16, kLmax = 4 * kN, kFractionBits = 11, kOddBits = 6, kBorderBits = 9;
  rc2::tb::Module<Vtop> border;
  for (int k = 1; k <= kN; ++k) {
    for (int distance = 1; distance <= kLmax; ++distance) {
      const std::int64_t exact = std::int64_t{distance} << kFractionBits;
      const std::int64_t least = (exact + 2 * k - 1) / (2 * k);
      const std::int64_t most = (exact + 2 * (2 * k) - 1) / (2 * k);
      for (const std::int64_t ratio : {least, most}) {
        border.ratio_i = static_cast<IData>(ratio);
        for (int odd = 1 - 2 * k; odd <= 2 * k - 1; odd += 2) {
          border.odd_i = static_cast<CData>(rc2::tb::bits(odd, kOddBits));
          border.eval();
          ASSERT_EQ(border.last_o,
                    rc2::tb::bits(rc2::floor_divide(odd * distance, 2 * k), kBorderBits))
              << "odd " << odd << " k " << k << " L " << distance;
        }
      }
    }
  }
}

}  // namespace
