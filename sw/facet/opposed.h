#pragma once

#include <cstdint>
#include <vector>

#include "sw/facet/packet.h"

namespace rc2::facet {

/// Indices of the packets that may share a voxel with one that faces the opposite way, ascending:
/// pairs whose boxes meet and, there, their slabs, as far as a plane half-way between them tells.
/// None is missing; thick solids have none.
std::vector<std::uint32_t> find_opposed(const std::vector<PacketHead>& packets);

}  // namespace rc2::facet
