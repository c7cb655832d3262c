#pragma once

#include <vector>

#include "sw/facet/shells.h"

namespace rc2::facet {

/// Marks the pieces that have so much surface around them that voxels cannot tell one side of it
/// from the other: in cubes of four voxels, on the average over the piece, more than two layers
/// and a half. If half of a shell's area is crowded, all of it is. `one`: vertex units per voxel.
std::vector<bool> find_crowded(const Traced& traced, const std::vector<const Pieces*>& shells,
                               std::int64_t one);

}  // namespace rc2::facet
