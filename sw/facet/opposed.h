#pragma once

#include <cstdint>
#include <vector>

#include "sw/facet/packet.h"
#include "sw/facet/polygon.h"

namespace rc2::facet {

/// Which way a normal faces: the signs of its large components as 9 (x+1) + 3 (y+1) + (z+1); the
/// opposite way is 26 less that. A component is large if it is 5/12 of the largest one or more:
/// between the axis and the diagonal that is half-way in angle, about tan 22.5 degrees.
int facing(const Vertex& normal);

/// Indices of the packets that may share a voxel with one that faces the opposite way, ascending:
/// pairs whose boxes meet and, there, their slabs, as far as a plane half-way between them tells.
/// None is missing; thick solids have none. A crowd faces no way.
std::vector<std::uint32_t> find_opposed(const std::vector<PacketHead>& packets);

}  // namespace rc2::facet
