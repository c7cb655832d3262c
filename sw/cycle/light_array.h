// The array while it is lit (rtl/rc2_array.sv): routers and beam engines of all cells.
#pragma once

#include <cstdint>
#include <vector>

#include "sw/cycle/diffuser.h"
#include "sw/cycle/router.h"
#include "sw/machine/queue_history.h"

namespace rc2::cycle {

class LightArray {
 public:
  LightArray(int n, Columns& columns);

  /// Lights the columns. Throws std::logic_error if targets are lost or beams block each other.
  LightResult run(const LightJob& job, const QueueObserver& observer, const Progress& progress);

 private:
  bool step(std::int64_t cycle);
  [[noreturn]] void report_deadlock(std::int64_t cycle) const;

  int n_;
  Columns& columns_;
  Router router_;
  Diffuser diffuser_;
  QueueHistory history_;
  std::vector<std::size_t> active_;   // cells that hold anything, in any order
  std::vector<std::uint8_t> listed_;  // per cell: is in active_
};

}  // namespace rc2::cycle
