#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace rc2 {

/// Wall time of one step after another, in seconds.
class Stopwatch {
 public:
  /// Ends the step that began at the last lap, or when the watch was made.
  void lap(const char* step) {
    const auto now = Clock::now();
    laps_.emplace_back(step, std::chrono::duration<double>(now - start_).count());
    start_ = now;
  }

  const std::vector<std::pair<std::string, double>>& laps() const { return laps_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<std::pair<std::string, double>> laps_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace rc2
