#pragma once

#include <cstdint>

#include "sw/surface/voxel_array.h"

namespace rc2::surface {

/// Pairs of neighbouring free voxels of which one is inside (winding number not 0) and the other
/// outside: where a ray passes the mesh unseen (thesis 2.1, "effet passe-muraille").
struct Tunnels {
  std::int64_t by_6 = 0;   ///< neighbours with a face in common
  std::int64_t by_18 = 0;  ///< a face or an edge
  std::int64_t by_26 = 0;  ///< a face, an edge or a corner
};

/// Both arrays have the same n.
Tunnels count_tunnels(const VoxelSet& occupied, const VoxelArray<std::int32_t>& winding);

}  // namespace rc2::surface
