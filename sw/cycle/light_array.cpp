#include "sw/cycle/light_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sw/cycle/cell.h"

namespace rc2::cycle {
namespace {

constexpr std::int64_t kProgressCycles = 4096;
constexpr std::size_t kNamedCells = 8;

}  // namespace

LightArray::LightArray(int n, Columns& columns)
    : n_(n),
      columns_(columns),
      router_(n),
      diffuser_(n, columns, router_),
      history_(columns.size()),
      listed_(columns.size()) {}

LightResult LightArray::run(const LightJob& job, const QueueObserver& observer,
                            const Progress& progress) {
  LightResult result;
  result.targets.total = total_targets(job.target_distance);
  columns_.darken();
  history_.start();
  router_.start(job);
  diffuser_.start(job);
  const auto source = cell_number(job.source.x, job.source.y, n_);
  std::fill(listed_.begin(), listed_.end(), 0);
  listed_[source] = 1;
  active_.assign(1, source);

  std::int64_t cycle = 0;
  while (!active_.empty()) {
    ++cycle;
    if (observer) observer(cycle, diffuser_.queues());
    if (!step(cycle)) report_deadlock(cycle);
    if (progress && cycle % kProgressCycles == 0) {
      progress("light", cycle,
               static_cast<double>(diffuser_.tally().home()) /
                   static_cast<double>(result.targets.total));
    }
  }

  result.cycles = cycle + 1;  // the last targets served are counted in the cycle after
  result.home_cycles = diffuser_.tally().home_cycle();
  result.visits = diffuser_.visits();
  result.max_queue = diffuser_.max_queue();
  result.queue_history = history_.signature();
  result.targets.absorbed = diffuser_.absorbed();
  result.targets.escaped = diffuser_.escaped();
  check_conservation(result.targets);
  return result;
}

// One cycle; false if nothing changed.
bool LightArray::step(std::int64_t cycle) {
  bool changed = false;
  const auto reached = [this](std::size_t cell) {
    if (listed_[cell] == 0) {
      listed_[cell] = 1;
      active_.push_back(cell);
    }
  };
  for (const std::size_t cell : active_) history_.add(cell, diffuser_.queues()[cell], cycle);
  const std::size_t before = active_.size();  // a cell that is reached now has nothing on its links
  for (std::size_t i = 0; i < before; ++i) {
    if (router_.move_links(active_[i], reached)) changed = true;
  }

  std::size_t kept = 0;
  for (const std::size_t cell : active_) {
    if (diffuser_.step(cell, cycle)) changed = true;
    router_.merge(cell);
    listed_[cell] = diffuser_.busy(cell) || router_.busy(cell) ? 1 : 0;
    if (listed_[cell] != 0) active_[kept++] = cell;
  }
  active_.resize(kept);
  return changed;
}

void LightArray::report_deadlock(std::int64_t cycle) const {
  std::string cells;
  for (std::size_t i = 0; i < std::min(active_.size(), kNamedCells); ++i) {
    const int cell = static_cast<int>(active_[i]);
    cells += fmt::format(" ({},{}) with {} beams;", cell % n_, cell / n_,
                         diffuser_.queues()[active_[i]]);
  }
  throw std::logic_error(fmt::format("the light is stuck in cycle {}: {} cells block each other:{}",
                                     cycle, active_.size(), cells));
}

}  // namespace rc2::cycle
