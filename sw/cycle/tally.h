// Counts targets (rtl/light/rc2_tally.sv and the registers of rtl/rc2_array.sv, rc2_machine.sv).
#pragma once

#include <algorithm>
#include <cstdint>

#include "sw/machine/machine.h"

namespace rc2::cycle {

/// The registers on the way home do nothing but wait, so an arrival's time is known when it starts.
class Tally {
 public:
  /// Targets of cell (x,y) end their way in this cycle, counted from the light's start.
  void finish(std::int64_t cycle, int x, int y, std::int64_t targets) {
    if (targets == 0) return;
    home_ += targets;
    // One cycle each for the product, the sum in the cell, in its row, and the root; one per cell
    // and row on the way.
    home_cycle_ = std::max(home_cycle_, cycle + x + y + 4);
  }

  std::int64_t home() const { return home_; }
  std::int64_t home_cycle() const { return home_cycle_; }

 private:
  std::int64_t home_ = 0, home_cycle_ = 0;
};

/// Throws std::logic_error unless every target came home.
void check_conservation(const TargetCount& targets);

}  // namespace rc2::cycle
