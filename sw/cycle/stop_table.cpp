#include "sw/cycle/stop_table.h"

#include <algorithm>

#include "sw/base/floor_divide.h"

namespace rc2::cycle {

int Slope::lowest(int offset) const {
  if (offset > step) return distance + 1;
  if (offset <= -step) return -distance;
  return floor_divide((2 * offset - 1) * distance, 2 * step) + 1;
}

int Slope::offset(int target) const {
  return -floor_divide(distance - 2 * target * step, 2 * distance);
}

void StopTable::fill(const Columns& columns, std::size_t column, const Slope& slope, int source_z,
                     int first, int last, std::int64_t cycle) {
  const int most = table_runs(columns.n());
  count_ = 0;
  known_ = {slope.lowest(first - source_z), slope.distance};
  int z = columns.next_stop(column, first);
  while (z <= last && count_ < most) {
    const int end = columns.next_passage(column, z);
    runs_[static_cast<std::size_t>(count_++)] = slope.between(z - source_z, end - 1 - source_z);
    z = columns.next_stop(column, end);
  }
  if (z <= last) known_.max = runs_[static_cast<std::size_t>(count_ - 1)].max;
  ready_ = cycle + 2 + count_;
}

StopTable::Passage StopTable::pass(Targets targets) const {
  const auto begin = runs_.begin(), end = begin + count_;
  const int last = std::min(targets.max, known_.max);
  const auto after =
      std::find_if(begin, end, [&](const Targets& run) { return run.min > targets.min; });
  Passage passage{{targets.min, last}, last};
  for (auto run = begin; run != end; ++run) {
    if (run->min <= targets.min && targets.min <= run->max) passage.free.min = run->max + 1;
  }
  if (after != end) {
    passage.free.max = std::min(last, after->min - 1);
    passage.end = std::min(last, after->max);
  }
  return passage;
}

}  // namespace rc2::cycle
