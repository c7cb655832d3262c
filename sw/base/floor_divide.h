#pragma once

namespace rc2 {

/// numerator / denominator rounded down; the denominator is positive.
template <typename Integer>
constexpr Integer floor_divide(Integer numerator, Integer denominator) {
  return numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
}

}  // namespace rc2
