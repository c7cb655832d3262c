// The readback, which the cycle model leaves out.
#pragma once

#include "sw/cycle/column.h"
#include "sw/machine/readback.h"

namespace rc2::tb {

/// What a cell of an n x n array says of the voxels of its column; counters are not the column's.
void answer(const cycle::Columns& columns, int n, std::size_t column, ReadWhat what,
            Readback& readback);

}  // namespace rc2::tb
