#pragma once

#include <cstdint>
#include <random>

namespace rc2::scene {

/// Random numbers that do not depend on the standard library: only the generator's own output is
/// fixed by the C++ standard, what its distributions make of it is not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// 0 <= result < 1, a multiple of 2^-53.
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

  /// low <= result < high.
  double between(double low, double high) { return low + (high - low) * unit(); }

  /// 0 <= result < count.
  int below(int count) { return static_cast<int>(unit() * count); }

 private:
  std::mt19937_64 bits_;
};

}  // namespace rc2::scene
