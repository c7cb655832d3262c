// Where a light will end, voxel by voxel (rtl/lanes/rc2_prepare.sv).
#pragma once

#include <cstdint>

#include "sw/cycle/column.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

/// Sets the stops of all columns for the light's rule; takes them as darken() leaves them. All
/// cells look at one voxel in a cycle. Returns the cycles until the last is at rest, none if there
/// is no voxel to look at or the rule is the thesis's.
std::int64_t prepare(const LightJob& light, int n, Columns& columns);

}  // namespace rc2::cycle
