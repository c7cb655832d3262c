// rc2_ymed against the division it replaces, for every offset, step and distance of n = 16.
#include "tb/rtl/block.h"

namespace {

TEST(Ymed, EqualsTheDivisionEverywhere) {
  constexpr int kN = 16;
  constexpr int kLmax = 4 * kN;
  rc2::tb::Module<Vtop> ymed;
  for (int k = 0; k < kN; ++k) {
    for (int w = 0; w <= k; ++w) {
      for (int distance = 1; distance <= kLmax; ++distance) {
        ymed.offset_i = static_cast<CData>(w);
        ymed.step_i = static_cast<CData>(k + 1);
        ymed.distance_i = static_cast<CData>(distance);
        ymed.eval();
        const int dividend = (2 * w + 1) * distance;
        const int divisor = 2 * (k + 1);
        ASSERT_EQ(ymed.floor_o, dividend / divisor) << "w " << w << " k " << k << " L " << distance;
        ASSERT_EQ(ymed.ceil_o, (dividend + divisor - 1) / divisor)
            << "w " << w << " k " << k << " L " << distance;
      }
    }
  }
}

}  // namespace
