// Rotating arbiter (rtl/parts/rc2_rotate.sv).
#pragma once

#include <cstdint>

#include "sw/cycle/bits.h"

namespace rc2::cycle {

/// A new light starts with a new one, so the same light takes the same cycles.
class Rotate {
 public:
  /// Whose turn it is: the first request at or after the place that follows the last grant.
  unsigned next(unsigned requests) const {
    const unsigned preferred = requests >> next_ << next_;
    return first_of(preferred != 0 ? preferred : requests);
  }

  /// Grants it.
  unsigned take(unsigned requests) {
    const unsigned way = next(requests);
    next_ = static_cast<std::uint8_t>(way + 1);
    return way;
  }

 private:
  std::uint8_t next_ = 0;
};

}  // namespace rc2::cycle
