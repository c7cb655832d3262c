// Writes a dexel into the column, one voxel per cycle (rtl/load/rc2_fill.sv).
#pragma once

#include <cstdint>

#include "sw/cycle/column.h"
#include "sw/facet/packet.h"

namespace rc2::cycle {

/// A facet fills voxels z0+lo .. z0+hi of a column; its core is z0+core_lo .. z0+core_hi; the
/// gap is gap_step*z + gap, z counted from z0.
struct Span {
  std::uint32_t facet;
  facet::Layer layer;
  facet::Surface surface;
  glm::ivec3 normal;
  int z0, lo, hi, core_lo, core_hi;
  std::int64_t gap, gap_step;
};

class Fill {
 public:
  explicit Fill(int n) : n_(n) {}

  bool ready() const { return !seeking_ && !walking_; }
  bool busy() const { return !ready() || writing_; }
  bool writing() const { return writing_; }

  /// One cycle of the unit of a column. `offered` is a dexel for it, or null; if ready it takes it.
  void step(const Span* offered, Columns& columns, std::size_t column);

 private:
  void write(Columns& columns, std::size_t column) const;
  Owner owner() const;

  int n_;
  bool seeking_ = false, walking_ = false, writing_ = false;
  int to_seek_ = 0;  // bits of lo that the gap at lo still lacks
  Span span_{};      // lo moves up while walking, and gap with it
  // A voxel is written in the cycle after the walk is there.
  int written_z_ = 0;
  Owner written_;
  facet::Layer written_layer_ = facet::Layer::armour;
};

}  // namespace rc2::cycle
