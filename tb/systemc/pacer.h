// When a stream may move: a seeded source of stalls that has several habits and changes between
// them.
#pragma once

#include <array>
#include <cstdint>

#include "tb/load/dice.h"

namespace rc2::tb {

class Pacer {
 public:
  /// Never stalls; stalls in 10, 50 or 90 of 100 cycles; stalls and moves for 1 to 30 cycles each.
  enum Habit : std::uint8_t { open, rare, even, slow, bursts };
  static constexpr std::size_t kHabits = 5;

  explicit Pacer(std::uint64_t seed) : dice_(seed) {}

  /// Whether the stream may move in the next cycle.
  bool go() {
    if (habit_left_-- == 0) change_habit();
    ++cycles_[habit_];
    if (habit_ != bursts) return dice_.roll(0, 99) >= kStalls[habit_];
    if (burst_left_-- == 0) {
      moving_ = !moving_;
      burst_left_ = dice_.roll(0, 29);
    }
    return moving_;
  }

  /// Starts anew; what was counted stays.
  void reseed(std::uint64_t seed) {
    dice_ = facet::Dice(seed);
    habit_left_ = burst_left_ = 0;
    moving_ = false;
  }

  /// Cycles in each habit.
  const std::array<std::int64_t, kHabits>& cycles() const { return cycles_; }

 private:
  static constexpr std::array<std::int64_t, kHabits> kStalls{0, 10, 50, 90, 0};

  void change_habit() {
    habit_ = static_cast<Habit>(dice_.roll(0, kHabits - 1));
    habit_left_ = dice_.roll(20, 200);
  }

  facet::Dice dice_;
  Habit habit_ = open;
  bool moving_ = false;
  std::int64_t habit_left_ = 0, burst_left_ = 0;
  std::array<std::int64_t, kHabits> cycles_{};
};

}  // namespace rc2::tb
