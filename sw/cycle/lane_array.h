// The array while it is lit in fast mode (rtl/rc2_array.sv): side lanes and z lanes of all cells.
#pragma once

#include "sw/cycle/extents.h"
#include "sw/cycle/light_array.h"
#include "sw/cycle/side_lane.h"
#include "sw/cycle/z_lanes.h"
#include "sw/machine/queue_history.h"

namespace rc2::cycle {

/// Steps from a voxel to the farthest face of the n-cube: no light takes more.
int farthest_face(const glm::ivec3& source, int n);

class LaneArray {
 public:
  /// `skips`: leaves out what can meet nothing.
  LaneArray(int n, bool skips, Columns& columns);

  /// To be called when the columns have been loaded: the cells learn where there is anything.
  void settle();

  /// Lights the columns. Throws Error if L is too fine for n, std::logic_error if targets are lost
  /// or beams block each other.
  LightResult run(const LightJob& job, const QueueObserver& observer, const Progress& progress);

 private:
  std::int64_t longest_wait() const;
  [[noreturn]] void report_deadlock(std::int64_t cycle) const;

  int n_;
  Columns& columns_;
  bool skips_;
  Extents extents_;
  SideLane side_;
  ZLanes z_;
  QueueHistory history_;
};

}  // namespace rc2::cycle
