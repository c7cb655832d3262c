#include "sw/cycle/lane_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace rc2::cycle {
int farthest_face(const glm::ivec3& source, int n) {
  int steps = 0;
  for (int axis = 0; axis < 3; ++axis) {
    steps = std::max({steps, source[axis], n - 1 - source[axis]});
  }
  return steps;
}

LaneArray::LaneArray(int n, Columns& columns)
    : n_(n), columns_(columns), side_(n, columns), z_(n, columns), history_(columns.size()) {}

LightResult LaneArray::run(const LightJob& job, const Observer& observer,
                           const Progress& progress) {
  LightResult result;
  result.targets.total = total_targets(job.target_distance);
  columns_.darken();
  const Classes classes(job.target_distance, farthest_face(job.source, n_) + 1);
  z_.run(job, classes);
  side_.start(job, classes);
  history_.start();
  std::int64_t cycle = 0, still = 0;
  while (side_.busy()) {
    ++cycle;
    if (observer) observer(cycle, side_.queues());
    for (const std::size_t cell : side_.active()) history_.add(cell, side_.queues()[cell], cycle);
    still = side_.step(cycle) ? 0 : still + 1;
    if (still > 4 * n_ + 64)
      throw std::logic_error(fmt::format("the light is stuck in cycle {}", cycle));
    if (progress && cycle % 1024 == 0) progress("light", cycle, 0.5);
  }
  result.cycles =
      std::max(side_.last_served() + 2, std::int64_t{2} * (farthest_face(job.source, n_) + 1));
  result.home_cycles = std::max(side_.tally().home_cycle(), z_.tally().home_cycle());
  result.visits = side_.visits() + z_.visits();
  result.merged = side_.merged();
  result.max_queue = side_.max_queue();
  result.queue_history = history_.signature();
  result.targets.absorbed = side_.absorbed() + z_.absorbed();
  result.targets.escaped = side_.escaped() + z_.escaped();
  if (result.targets.absorbed + result.targets.escaped != result.targets.total) {
    throw std::logic_error(fmt::format("conservation is broken: {} + {} != {}",
                                       result.targets.absorbed, result.targets.escaped,
                                       result.targets.total));
  }
  return result;
}

}  // namespace rc2::cycle
