// The queues of all cells through which rays travel, and what lies in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sw/cycle/ray_ways.h"

namespace rc2::cycle {

/// Who may send from a cell (rtl/rays/rc2_ray_net.sv). A queue takes messages of one class from one
/// side, so that no message waits behind one that goes elsewhere for another reason. The last of
/// the answers and of the starts, and the ray that has begun here, are no queues: they wait where
/// they are made.
namespace ray_queue {
constexpr unsigned kRays = 0;      ///< 4 quadrants from 2 sides: quadrant * 2 + axis
constexpr unsigned kLaunched = 8;  ///< the ray that has begun here
constexpr unsigned kAnswers = 9;   ///< by the way they came
constexpr unsigned kOwnAnswer = 13;
constexpr unsigned kStarts = 14;  ///< by the way they came
constexpr unsigned kHome = 18;    ///< the rays of the cell's own pixel
constexpr unsigned kSenders = 19;
constexpr unsigned kSpawned = 19;  ///< rays that are to begin here: these go nowhere else
constexpr unsigned kCount = 20;
}  // namespace ray_queue

/// FIFOs of equal depth, a handle a place. What is pushed and popped in a cycle shows in the next.
class RayQueues {
 public:
  RayQueues(std::size_t cells, int depth)
      : depth_(static_cast<std::size_t>(depth)),
        queues_(cells * ray_queue::kCount),
        places_(queues_.size() * depth_) {}

  static std::size_t number(std::size_t cell, unsigned queue) {
    return cell * ray_queue::kCount + queue;
  }

  bool empty(std::size_t queue) const { return queues_[queue].count == 0; }
  std::size_t room(std::size_t queue) const { return depth_ - queues_[queue].count; }
  std::uint32_t front(std::size_t queue) const {
    return places_[queue * depth_ + queues_[queue].head];
  }

  void pop(std::size_t queue) { popped_.push_back(queue); }
  void push(std::size_t queue, std::uint32_t handle) { pushed_.emplace_back(queue, handle); }

  /// The clock's edge. Returns how many messages have moved.
  std::size_t step() {
    for (const std::size_t queue : popped_) {
      queues_[queue].head = (queues_[queue].head + 1) % depth_;
      --queues_[queue].count;
    }
    for (const auto& [queue, handle] : pushed_) {
      Queue& of = queues_[queue];
      places_[queue * depth_ + (of.head + of.count) % depth_] = handle;
      ++of.count;
    }
    const std::size_t moved = popped_.size() + pushed_.size();
    popped_.clear();
    pushed_.clear();
    return moved;
  }

 private:
  struct Queue {
    std::size_t head = 0, count = 0;
  };

  std::size_t depth_;
  std::vector<Queue> queues_;
  std::vector<std::uint32_t> places_;
  std::vector<std::size_t> popped_;
  std::vector<std::pair<std::size_t, std::uint32_t>> pushed_;
};

/// Things by handle.
template <typename Thing>
class Pool {
 public:
  std::uint32_t add(Thing thing) {
    if (free_.empty()) {
      things_.push_back(std::move(thing));
      return static_cast<std::uint32_t>(things_.size() - 1);
    }
    const std::uint32_t handle = free_.back();
    free_.pop_back();
    things_[handle] = std::move(thing);
    return handle;
  }
  Thing& operator[](std::uint32_t handle) { return things_[handle]; }
  Thing take(std::uint32_t handle) {
    free_.push_back(handle);
    return std::move(things_[handle]);
  }
  bool empty() const { return free_.size() == things_.size(); }

 private:
  std::vector<Thing> things_;
  std::vector<std::uint32_t> free_;
};

}  // namespace rc2::cycle
