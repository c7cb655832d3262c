// The loading units of a cell, beside its stage of the row's pipe (rtl/rc2_cell.sv).
#pragma once

#include <cstddef>

#include "sw/cycle/column.h"
#include "sw/cycle/dexel.h"
#include "sw/cycle/fill.h"

namespace rc2::cycle {

class CellLoader {
 public:
  explicit CellLoader(int n) : fill_(n) {}

  bool dividing() const { return dexel_.dividing(); }
  bool filling() const { return fill_.busy(); }
  bool busy() const { return filling() || seeking_ > 0; }
  bool writing() const { return fill_.writing(); }

  /// Whether a word that waits in the stage may leave at the end of this cycle.
  bool ready(const Word& word) const;

  /// One cycle of the cell with this column. `word` waits in the stage, or is null; it leaves at
  /// the end if `taken`.
  void step(const Word* word, bool taken, Columns& columns, std::size_t column);

 private:
  // The words of a facet for rays (rtl/rays/rc2_ray_surface.sv): the voxels of the HEAD's box are
  // looked through, one a cycle.
  void step_seek(const Word* word, bool taken);

  int z_span_ = 0;   // of the last HEAD
  int seeking_ = 0;  // cycles that this still takes
  Dexel dexel_;
  Fill fill_;
};

}  // namespace rc2::cycle
