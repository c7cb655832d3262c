// The two z lanes of all cells: light towards the z faces (rtl/lanes/rc2_z_lanes.sv).
#pragma once

#include <cstdint>
#include <vector>

#include "sw/cycle/classes.h"
#include "sw/cycle/column.h"
#include "sw/cycle/extents.h"
#include "sw/cycle/tally.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

/// The front of a z lane after k steps lies in layer zs + k or zs - k. In a voxel of it the light
/// is a matrix of bits, one for each pair of a U class and a V class: a class that is stopped is
/// stopped whole. In a step each bit goes where its two classes go; nothing ever waits.
class ZLanes {
 public:
  ZLanes(int n, Columns& columns);

  /// Lights the columns; the wave takes two cycles a step, one for each lane. `outlooks` says of
  /// each cell what light can still meet.
  void run(const LightJob& light, const Classes& classes, const std::vector<Outlook>& outlooks);

  /// The last cycle in which there was light in a cell.
  std::int64_t last_busy() const { return last_busy_; }
  const Tally& tally() const { return tally_; }
  std::int64_t absorbed() const { return absorbed_; }
  std::int64_t escaped() const { return escaped_; }
  std::int64_t skipped() const { return skipped_; }
  std::int64_t visits() const { return visits_; }  ///< voxels that light reached

 private:
  struct Box {
    int x0, x1, y0, y1;
  };
  void run_lane(bool down);
  void enter(const Box& box, int step, int z, std::int64_t cycle);
  void advance(const Box& from, const Box& to, int step);
  void leave(const Box& box, int step, bool all, std::int64_t cycle);
  std::int64_t targets(int step, int dx, int dy, const ClassSet* matrix) const;
  std::int64_t kept(int step, int at, int offset, ClassSet set) const;

  ClassSet* rows(std::vector<ClassSet>& front, int x, int y) const;

  int n_;
  Columns& columns_;
  LightJob light_{};
  const Classes* classes_ = nullptr;
  const std::vector<Outlook>* outlooks_ = nullptr;
  std::size_t height_ = 0;  // rows of a matrix
  std::vector<ClassSet> now_, next_;
  Tally tally_;
  std::int64_t last_busy_ = 0, absorbed_ = 0, escaped_ = 0, skipped_ = 0, visits_ = 0;
};

}  // namespace rc2::cycle
