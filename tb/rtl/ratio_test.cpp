// rc2_ratio against the division it replaces: L/2k, less than two units too large.
#include "tb/rtl/block.h"

namespace {

TEST(Ratio, IsLessThanTwoUnitsTooLarge) {
  constexpr int kN = 16, kLmax = 4 * kN, kFractionBits = 11;
  rc2::tb::Module<Vtop> ratio;
  for (int k = 3; k <= kN; ++k) {
    ratio.step_i = static_cast<CData>(k);
    ratio.clk_i = 0;
    ratio.eval();
    ratio.clk_i = 1;
    ratio.eval();
    for (int distance = 1; distance <= kLmax; ++distance) {
      ratio.distance_i = static_cast<CData>(distance);
      ratio.eval();
      const std::int64_t error = static_cast<std::int64_t>(ratio.ratio_o) * 2 * k -
                                 (std::int64_t{distance} << kFractionBits);
      ASSERT_GE(error, 0) << "k " << k << " L " << distance;
      ASSERT_LT(error, 2 * 2 * k) << "k " << k << " L " << distance;
    }
  }
}

}  // namespace
