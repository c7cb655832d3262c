// The array while rays are traced (docs/render.md has the network and why it cannot block).
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "sw/cycle/column.h"
#include "sw/cycle/ray_engine.h"
#include "sw/cycle/rotate.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

/// One trace. Four classes of messages: a *start* brings a ray from its home to the cell where it
/// begins, a *ray* goes its way, an *answer* brings the hit home, and with it those new rays for
/// which there was no room where it was made; the home takes every answer.
class RayArray {
 public:
  /// Everything must outlive this.
  RayArray(int n, const Columns& columns, const RayUnits& units, const RayJob& job);

  /// Throws std::logic_error if the array blocks or loses a ray.
  RayResult run(const Progress& progress);

 private:
  struct Answer {
    RayHit hit;
    std::vector<RayBegin> onwards;  // the mirrored one first
  };
  // What a cell has beside its queues.
  struct Cell {
    std::deque<std::uint32_t> home;  // its own pixel's rays that wait to be started
    RayEngine engine;
    std::optional<std::uint32_t> launched, answer;
    Rotate home_turn, start_turn;
    std::array<Rotate, kHere> link_turn;
    std::array<std::int64_t, kHere> sent{};  // over each link
    std::optional<unsigned> held;            // the answer whose first ray has been taken home
    std::uint32_t messages = 0;              // in its queues
    bool begins_child = false;               // in this cycle
    std::array<std::uint32_t, kHere + 1>
        wishes{};  // in this cycle: of each way, who wants to go it
  };

  void serve(std::size_t cell);
  void work(std::size_t cell);
  void answer(std::size_t cell);
  void drive_link(std::size_t cell, unsigned way);
  void begin_ray(std::size_t cell);
  void take_home(std::size_t cell);
  void spawn(std::size_t cell, std::uint32_t start);
  void wait_at_home(std::size_t cell, const RayBegin& start);

  // The message that a sender has, if it has one.
  std::optional<std::uint32_t> front(std::size_t cell, unsigned sender) const;
  // Where it wants to go, if anywhere yet.
  std::optional<unsigned> wish(std::size_t cell, unsigned sender);
  // Of the neighbour that way, the queue for it.
  std::size_t next_queue(std::size_t cell, unsigned sender, unsigned way);
  // It has left.
  void let_go(std::size_t cell, unsigned sender);
  void push(std::size_t cell, unsigned queue, std::uint32_t handle);
  std::size_t room(std::size_t cell, unsigned queue) const {
    return queues_.room(RayQueues::number(cell, queue));
  }
  glm::ivec2 place(std::size_t cell) const;

  int n_;
  const RayJob& job_;
  RayQueues queues_;
  std::vector<Cell> cells_;
  Pool<RayWalk> rays_;
  Pool<Answer> answers_;
  Pool<RayBegin> starts_;
  std::int64_t cycle_ = 0;
  std::int64_t rays_left_ = 0;  // that wait at home or are on their way, and answers
  RayResult result_;
  RayWorld world_;
};

}  // namespace rc2::cycle
