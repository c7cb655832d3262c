// One line on stderr that tells how far a long step has come.
#pragma once

#include <chrono>
#include <string>

#include "sw/machine/machine.h"

namespace rc2 {

/// Shown once a step has taken a second: redrawn in place on a terminal, elsewhere a new line
/// every ten seconds. Machines limit how often they call, so every call may look at the clock.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar() { wipe(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Starts a step; what it returns is for the machine and lives no longer than the bar.
  Progress step(const std::string& title);

  /// Clears the line, so that what is printed next starts in the first column.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;

  void show(std::int64_t cycles, double share);

  bool terminal_;
  bool drawn_ = false;
  std::string title_;
  Clock::time_point start_, next_;
};

}  // namespace rc2
