#pragma once

#include "sw/facet/packet.h"
#include "sw/golden/grid.h"

namespace rc2::golden {

/// Fills the voxels of one facet: those of its box where every bound holds (thesis 3.7).
/// A voxel that several facets share goes to the lowest facet number, in whatever order they come.
/// `bounds` are the bounds of this packet.
void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Bound* bounds);

}  // namespace rc2::golden
