// The pages of pictures of thesis 4.4.3: which voxels have been reached, and which cells are at
// work.
#pragma once

#include <cstdint>
#include <vector>

#include "sw/picture/raster.h"
#include "sw/thesis/experiment.h"

namespace rc2::thesis {

/// A row holds n slices of n squares: more would be of no use on a screen.
constexpr int kMaxSheetSide = 64;

struct ContactSheet {
  picture::Raster raster;
  std::vector<std::int64_t> times;  ///< of its rows: those asked for, then the end
};

/// One row for the state after each of `times` cycles (ascending), and one for the end. A row is
/// its time, the slices z = 0 .. n-1 (black: a beam has been there) and, apart, the array (black:
/// the cell's queue is not empty). x goes to the right, y upwards. n <= kMaxSheetSide. Throws Error
/// if the diffusion ends before the last of the times.
ContactSheet draw_contact_sheet(const Experiment& experiment,
                                const std::vector<std::int64_t>& times);

}  // namespace rc2::thesis
