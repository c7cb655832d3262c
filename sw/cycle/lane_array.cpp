#include "sw/cycle/lane_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sw/base/error.h"
#include "sw/cycle/prepare.h"

namespace rc2::cycle {
namespace {

constexpr std::int64_t kProgressCycles = 1024;
constexpr std::size_t kNamedCells = 8;

// Classes that fit in a set beside the one of x beams alone (SideLane).
constexpr int kMostClasses = 63;

}  // namespace

int farthest_face(const glm::ivec3& source, int n) {
  int steps = 0;
  for (int axis = 0; axis < 3; ++axis) {
    steps = std::max({steps, source[axis], n - 1 - source[axis]});
  }
  return steps;
}

LaneArray::LaneArray(int n, bool skips, Columns& columns)
    : n_(n),
      columns_(columns),
      skips_(skips),
      extents_(n),
      side_(n, columns),
      z_(n, columns),
      history_(columns.size()) {}

void LaneArray::settle() {
  if (skips_) extents_.settle(columns_);
}

LightResult LaneArray::run(const LightJob& job, const QueueObserver& observer,
                           const Progress& progress) {
  const int kmax = farthest_face(job.source, n_);
  const Classes classes(job.target_distance, kmax + 1);
  if (classes.most() > kMostClasses) {
    throw Error(
        fmt::format("L = {} is too fine for light in lanes at n = {}; choose a smaller L, "
                    "or thesis mode",
                    job.target_distance, n_));
  }
  LightResult result;
  result.targets.total = total_targets(job.target_distance);
  columns_.darken();
  result.prepare_cycles = prepare(job, n_, columns_);
  history_.start();
  const Extent all{0, n_ - 1};
  const std::vector<Outlook> outlooks = skips_
                                            ? extents_.seen_from(job.source)
                                            : std::vector<Outlook>(columns_.size(), {all, all, 0});
  z_.run(job, classes, outlooks);
  side_.start(job, classes, outlooks);

  std::int64_t cycle = 0, still = 0;
  while (side_.busy()) {
    ++cycle;
    if (observer) observer(cycle, side_.queues());
    for (const std::size_t cell : side_.active()) history_.add(cell, side_.queues()[cell], cycle);
    still = side_.step(cycle) ? 0 : still + 1;
    if (still > longest_wait()) report_deadlock(cycle);
    if (progress && cycle % kProgressCycles == 0) {
      progress("light", cycle,
               static_cast<double>(side_.tally().home() + z_.tally().home()) /
                   static_cast<double>(result.targets.total));
    }
  }

  result.cycles = std::max(side_.last_busy(), z_.last_busy());
  result.home_cycles = std::max(side_.tally().home_cycle(), z_.tally().home_cycle());
  result.visits = side_.visits() + z_.visits();
  result.merged = side_.merged();
  result.max_queue = side_.max_queue();
  result.queue_history = history_.signature();
  result.targets.absorbed = side_.absorbed() + z_.absorbed();
  result.targets.escaped = side_.escaped() + z_.escaped();
  result.targets.skipped = side_.skipped() + z_.skipped();
  check_conservation(result.targets);
  return result;
}

// Cycles in which nothing may move: until the classes of the farthest cells are there, and a table
// is filled.
std::int64_t LaneArray::longest_wait() const { return std::int64_t{2} * n_ + table_runs(n_) + 8; }

void LaneArray::report_deadlock(std::int64_t cycle) const {
  std::string cells;
  for (std::size_t i = 0; i < std::min(side_.active().size(), kNamedCells); ++i) {
    const auto cell = static_cast<int>(side_.active()[i]);
    cells += fmt::format(" ({},{}) with {} beams;", cell % n_, cell / n_,
                         side_.queues()[side_.active()[i]]);
  }
  throw std::logic_error(fmt::format("the light is stuck in cycle {}: {} cells block each other:{}",
                                     cycle, side_.active().size(), cells));
}

}  // namespace rc2::cycle
