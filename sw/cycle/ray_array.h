// The array while rays are traced (docs/render.md has the network and why it cannot block).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sw/cycle/column.h"
#include "sw/cycle/ray_queues.h"
#include "sw/cycle/ray_walk.h"
#include "sw/cycle/rotate.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

/// One trace. Four classes of messages: a *start* brings a ray from its home to the cell where it
/// begins, a *ray* goes its way, an *answer* brings the hit home, and with it those new rays for
/// which there was no room where it was made; the home takes every answer.
class RayArray {
 public:
  /// Everything must outlive this.
  RayArray(int n, const Columns& columns, const RayJob& job);

  /// Throws std::logic_error if the array blocks or loses a ray.
  RayResult run(const Progress& progress);

 private:
  // A ray and the age that it begins with.
  struct Start {
    rays::Ray ray;
    std::int64_t age;
  };
  struct Answer {
    RayHit hit;
    std::vector<Start> onwards;
  };
  // What a cell has beside its queues.
  struct Cell {
    std::vector<Start> stack;  // of its own pixel's rays that wait to be started
    Rotate probe_turn, end_turn, home_turn, start_turn;
    std::array<Rotate, kHere> link_turn;
    std::int64_t probing_until = 0;  // from this cycle on the probe is free
    std::int64_t probe_cycles = 0;
    std::uint32_t messages = 0;     // in its queues
    std::size_t room_to_spawn = 0;  // in this cycle
  };

  void serve(std::size_t cell);
  void probe(std::size_t cell);
  void end_ray(std::size_t cell);
  void answer(std::size_t cell, unsigned queue, unsigned answers);
  void drive_link(std::size_t cell, unsigned way);
  void take_home(std::size_t cell);
  void begin_rays(std::size_t cell);
  void spawn(std::size_t cell, const Start& start);
  void wait_at_home(std::size_t cell, const Start& start);

  // Where the message at the head of a queue wants to go, if anywhere yet.
  std::optional<unsigned> wish(std::size_t cell, unsigned queue);
  // Of the neighbour that way, the queue for the message at the head of this one.
  std::size_t next_queue(std::size_t cell, unsigned queue, unsigned way);
  glm::ivec2 place(std::size_t cell) const;

  template <typename Test>
  std::uint32_t those(unsigned first, unsigned count, Test test) const;
  void pop(std::size_t cell, unsigned queue);
  void push(std::size_t cell, unsigned queue, std::uint32_t handle);

  int n_;
  const Columns& columns_;
  const RayJob& job_;
  RayQueues queues_;
  std::vector<Cell> cells_;
  Pool<RayWalk> rays_;
  Pool<Answer> answers_;
  Pool<Start> starts_;
  std::int64_t cycle_ = 0;
  std::int64_t last_probe_ = 0;  // the cycle in which any was begun
  std::int64_t at_home_ = 0;     // rays that wait to be started
  RayResult result_;
};

}  // namespace rc2::cycle
