// The stops of a column, seen as targets (rtl/lanes/rc2_stops.sv).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sw/cycle/column.h"

namespace rc2::cycle {

/// Targets min .. max; none if max < min.
struct Targets {
  int min, max;
  bool none() const { return max < min; }
  std::int64_t count() const { return none() ? 0 : std::int64_t{max} - min + 1; }
};

/// Where the V targets of a light are after `step` >= 1 steps: at offset v * step / L, rounded to
/// the nearest, ties downwards (thesis 4.3.1).
struct Slope {
  int step, distance;

  /// The lowest target at `offset` or above: -L .. L+1.
  int lowest(int offset) const;

  /// The targets at offsets `low` .. `high`.
  Targets between(int low, int high) const { return {lowest(low), lowest(high + 1) - 1}; }

  /// The offset of a target's ray.
  int offset(int target) const;
};

/// How many runs a table holds, of columns of n voxels (rtl/rc2_pkg.sv).
constexpr int kMostTableRuns = 8;
constexpr int table_runs(int n) { return n > 128 ? kMostTableRuns : 6; }

/// A few runs of stopping voxels as intervals of targets, in order: what a beam needs to know of
/// the column. A column with more runs has its table filled anew where a beam asks for it.
class StopTable {
 public:
  /// The runs from voxel `first` on, up to voxel `last`. In RTL the first cycle finds a run, each
  /// later one the targets of a run and the next run; the table can be used in the cycle after.
  void fill(const Columns& columns, std::size_t column, const Slope& slope, int source_z, int first,
            int last, std::int64_t cycle);

  std::int64_t ready() const { return ready_; }

  bool knows(int target) const { return target >= known_.min && target <= known_.max; }

  /// What becomes of targets min .. max, as far as one visit gets: those below `free` stop, `free`
  /// pass, those above it up to `end` stop, the others have to ask again. The table knows min.
  struct Passage {
    Targets free;
    int end;
  };
  Passage pass(Targets targets) const;

 private:
  std::array<Targets, kMostTableRuns> runs_;
  int count_ = 0;
  Targets known_{0, -1};
  std::int64_t ready_ = 0;
};

}  // namespace rc2::cycle
