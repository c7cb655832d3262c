// Facet packets: what the host sends into the array (thesis 3.9, "precalcul").
//
// A packet is a box of voxels and a list of bounds. Voxel p of the box belongs to the facet when
// every bound holds. The first two bounds are the slab (the thesis's T and U), the others are the
// sides (its Ti). Everything is an exact integer; no floating point passes this door.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rc2::facet {

/// The bound a*x + b*y + c*z + d >= 0, (x,y,z) counted from the low corner of the packet's box.
struct Bound {
  std::int64_t a, b, c, d;
};

/// One facet: voxels lo..hi (inclusive, inside the grid) and its share of PacketStream::bounds.
struct PacketHead {
  std::uint32_t facet;  ///< number of the facet, unique, < kMaxFacets
  glm::ivec3 lo, hi;
  std::uint32_t first_bound, bound_count;  ///< bound_count >= 2
};

/// Packets in the order in which they enter the machine.
struct PacketStream {
  std::vector<PacketHead> heads;
  std::vector<Bound> bounds;
};

}  // namespace rc2::facet
