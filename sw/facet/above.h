// What lies above a facet: voxels for the packets that fill solids, points for what encloses what.
//
// A ray upwards from a point inside a closed mesh crosses an odd number of facets, so the parity of
// the facets below a voxel's centre says whether it is inside. Points count as p + (e, e^2, e^3),
// e -> 0+: none lies on a facet, none above an edge.
#pragma once

#include "sw/facet/packet.h"
#include "sw/facet/polygon.h"

namespace rc2::facet {

/// Whether the facet is straight above the point, both in vertex units.
bool is_over(const Border& border, const Vertex& normal, const Vertex& point);

/// Appends the packet of the voxels of an n-cube whose centres lie straight above the facet, one
/// vertex unit being 1/one voxel. Appends nothing if no centre can, as with a facet on edge.
void append_above(const Border& border, const Vertex& normal, std::uint32_t facet, int n,
                  std::int64_t one, PacketStream& stream);

}  // namespace rc2::facet
