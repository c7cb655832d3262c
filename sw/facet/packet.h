// Facet packets: what the host sends into the array (thesis 3.9, "precalcul").
//
// A packet is a box of voxels, a slab and sides. Voxel p of the box belongs to the facet when it is
// within the slab (the thesis's T and U) and on the inner side of every side (its Ti). A voxel that
// several facets share goes to the one that has the better claim to it (sw/machine/claim.h), for
// which a packet says how far its sides are pushed out and where its plane is. Everything is an
// exact integer; no floating point passes this door.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rc2::facet {

/// The value a*x + b*y + c*z + d, (x,y,z) counted from the low corner of the packet's box.
struct Linear {
  std::int64_t a, b, c, d;
};

/// 0 <= value <= width.
struct Slab {
  Linear value;
  std::int64_t width;
};

/// value >= 0. The voxel centre lies within the border of the facet itself, before it was pushed
/// out, where value >= push.
struct Side {
  Linear value;
  std::int64_t push;
};

/// One facet: voxels lo..hi (inclusive, inside the grid) and its share of PacketStream::sides.
struct PacketHead {
  std::uint32_t facet;  ///< number of the facet, unique, < kMaxFacets
  glm::ivec3 lo, hi;
  Slab slab;
  Linear gap;  ///< of a voxel centre from the plane; see Claim for its unit
  std::uint32_t first_side, side_count;
};

/// Packets in the order in which they enter the machine.
struct PacketStream {
  std::vector<PacketHead> heads;
  std::vector<Side> sides;
};

}  // namespace rc2::facet
