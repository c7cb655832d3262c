// The tables of thesis 4.4.3 and the comparison of 4.2.6, for any size.
#pragma once

#include <optional>
#include <string>

#include "sw/machine/machine.h"
#include "sw/thesis/experiment.h"

namespace rc2::thesis {

enum class Table {
  kFaMax,    ///< n,fa_needed,t: the +z cone, queues without end
  kFa1,      ///< n,t: three cones, FA = 1
  kFaSweep,  ///< n,fa,t: three cones
  kModes,    ///< 4.2.6: rays one by one against beams, queues without end
};

/// The integers first .. last, first <= last.
struct Range {
  int first, last;
};

struct TableRequest {
  Table table;
  Range n;
  std::optional<Range> fa;  ///< of kFaSweep, and only of it
  Conflict conflict = Conflict::kHeadWaits;
};

/// Throws Error if a range is out of bounds, missing, or has no meaning for the table.
void check(const TableRequest& request);

/// A request that was checked, as CSV with a heading; t counts cycles. Columns of kModes: n, the
/// cones sent (plane: one octant of a plane; x, z: that cone; xyz: three cones; all from the
/// corner), their rays, and for either mode the cycles and the beams served.
std::string to_csv(const TableRequest& request, const Progress& progress);

}  // namespace rc2::thesis
