// One coordinate of a digital ray (thesis 2.3.1 and 4.3.1).
#pragma once

#include <cstdint>

namespace rc2::lines {

/// After k steps towards target j on a face at distance L the offset is the integer nearest to
/// j*k/L, ties downwards. This is Bresenham's line: `error` is 2*(j*k - L*offset) - L, and the
/// offset is right as long as it stays in (-2L, 0].
class DigitalLine {
 public:
  DigitalLine(std::int64_t target, std::int64_t distance)
      : slope_(2 * target), period_(2 * distance), error_(-distance) {}

  /// Goes one step on and returns the change of the offset: -1, 0 or 1.
  int advance() {
    error_ += slope_;
    const int change = static_cast<int>(error_ > 0) - static_cast<int>(error_ <= -period_);
    error_ -= change * period_;
    return change;
  }

 private:
  std::int64_t slope_, period_, error_;
};

}  // namespace rc2::lines
