// Writes a dexel into the column, one voxel per cycle (rtl/load/rc2_fill.sv).
#pragma once

#include <cstdint>

#include "sw/cycle/column.h"

namespace rc2::cycle {

/// Facet `facet` fills voxels lo..hi of a column.
struct Span {
  std::uint32_t facet;
  int lo, hi;
};

class Fill {
 public:
  bool ready() const { return !walking_; }
  bool busy() const { return walking_ || writing_; }

  /// One cycle of the unit of a column. `offered` is a dexel for it, or null; if ready it takes it.
  void step(const Span* offered, Columns& columns, std::size_t column);

 private:
  bool walking_ = false, writing_ = false;
  Span span_{};        // lo moves up while walking
  int written_z_ = 0;  // a voxel is written in the cycle after the walk is there
  std::uint32_t written_facet_ = 0;
};

}  // namespace rc2::cycle
