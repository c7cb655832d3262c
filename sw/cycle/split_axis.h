// Splits a beam's interval of targets along one axis (rtl/light/rc2_split_axis.sv).
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>

#include "sw/cycle/beam.h"
#include "sw/cycle/ymed.h"

namespace rc2::cycle {

/// Places in Parts, and bits (1 << place) in a set of parts.
enum Place : unsigned { kLow = 0, kMiddle = 1, kHigh = 2 };

/// The parts of an interval that go one cell down, straight on and one cell up; only those in
/// `present` are not empty.
struct Parts {
  std::array<Range, 3> part;
  unsigned present;
};

/// `offset` is the cell's from the source, `step` is k+1 (thesis 4.3.1.3, 4.3.3).
inline Parts split_axis(Range targets, int offset, int step, int distance) {
  // Targets up to `down` go low, targets above `up` go high; off the axis rays only move outward.
  const Ymed border = ymed(std::abs(offset), step, distance);
  const int up = border.floor;
  const int down = -border.ceil;
  const bool low = offset <= 0 && targets.min <= down;
  const bool high = offset >= 0 && targets.max > up;
  const Range middle = range(low ? down + 1 : targets.min, high ? up : targets.max);
  return {{range(targets.min, std::min<int>(targets.max, down)), middle,
           range(std::max<int>(targets.min, up + 1), targets.max)},
          (low ? 1U << kLow : 0U) | (middle.min <= middle.max ? 1U << kMiddle : 0U) |
              (high ? 1U << kHigh : 0U)};
}

}  // namespace rc2::cycle
