// Where a beam splits (rtl/light/rc2_ymed.sv, there without a divider).
#pragma once

#include <cstdint>

namespace rc2::cycle {

/// Y_med rounded down and up (thesis 4.3.1.2).
struct Ymed {
  int floor, ceil;
};

/// (2w+1)*L / (2*(k+1)) for offset w >= 0, step = k+1 and distance L.
inline Ymed ymed(int offset, int step, int distance) {
  const auto product = static_cast<std::uint32_t>((2 * offset + 1) * distance);
  const auto divisor = static_cast<std::uint32_t>(2 * step);
  const std::uint32_t quotient = product / divisor;
  const bool exact = quotient * divisor == product;
  return {static_cast<int>(quotient), static_cast<int>(quotient) + (exact ? 0 : 1)};
}

}  // namespace rc2::cycle
