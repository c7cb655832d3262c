#pragma once

#include "sw/facet/packet.h"
#include "sw/golden/grid.h"

namespace rc2::golden {

/// Fills the voxels of one facet: those of its box within its slab and sides (thesis 3.7). The grid
/// keeps the best packed Claim to each voxel, in whatever order facets come.
/// `sides` are the sides of this packet.
void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Side* sides);

}  // namespace rc2::golden
