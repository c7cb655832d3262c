// Random numbers that are the same with every compiler and library, which those of <random> are not
// once they are given a range.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

namespace rc2::facet {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits (SplitMix64).
  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9;
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EB;
    return mixed ^ mixed >> 31;
  }

  /// low <= result <= high, all alike; the range must be less than 2^32.
  std::int64_t roll(std::int64_t low, std::int64_t high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<std::int64_t>((bits() >> 32) * count >> 32);
  }

  bool one_in(std::int64_t count) { return roll(1, count) == 1; }

  bool chance(int percent) { return roll(1, 100) <= percent; }

  template <typename Iterator>
  void shuffle(Iterator first, Iterator last) {
    for (auto left = last - first; left > 1; --left) {
      std::swap(first[left - 1], first[roll(0, left - 1)]);
    }
  }

  /// 1 <= result <= high, every number of binary digits alike: from the smallest to the largest.
  std::int64_t roll_size(std::int64_t high) {
    int digits = 0;
    while (high >> digits != 0) ++digits;
    const std::int64_t least = std::int64_t{1} << (roll(1, digits) - 1);
    return roll(least, std::min(high, 2 * least - 1));
  }

 private:
  std::uint64_t state_;
};

}  // namespace rc2::facet
