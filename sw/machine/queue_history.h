// A signature of how deep the queues of all cells were in every cycle (rtl/parts/rc2_history.sv).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rc2 {

/// What one cell adds up: depth * cycle * cycle in each cycle, modulo 2^16.
class QueueHistory {
 public:
  explicit QueueHistory(std::size_t cells) : sums_(cells) {}

  void start() { sums_.assign(sums_.size(), 0); }

  void add(std::size_t cell, std::uint32_t depth, std::int64_t cycle) {
    const auto t = static_cast<std::uint32_t>(cycle);
    sums_[cell] = static_cast<std::uint16_t>(sums_[cell] + depth * t * t);
  }

  void set(std::size_t cell, std::uint16_t sum) { sums_[cell] = sum; }

  /// One number for all cells, in which each has a factor of its own.
  std::uint64_t signature() const {
    std::uint64_t all = 0, factor = 1;
    for (const std::uint16_t sum : sums_) {
      all += factor * sum;
      factor *= 0x9E3779B97F4A7C15;
    }
    return all;
  }

 private:
  std::vector<std::uint16_t> sums_;
};

}  // namespace rc2
