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

/// What a packet does to the voxels that it fills.
enum class Layer : std::uint8_t {
  armour = 0,  ///< occupies them and claims them for its facet
  shown = 1,   ///< marks them as shown
  inside = 2,  ///< flips the parity of them, and of all voxels above them in their columns
  guard = 3,   ///< claims those that are not occupied, to stop light behind something thin
};

/// What a facet is part of, for the accurate light rule (docs/light.md).
enum class Surface : std::uint8_t {
  solid = 0,  ///< of a body: light ends at it if it turns away
  sheet = 1,  ///< of something without an inside: light ends behind it, whichever way it comes
  crowd = 2,  ///< too much surface around it to tell one side from the other: light ends at it
};

/// One facet: voxels lo..hi (inclusive, inside the grid) and its share of PacketStream::sides.
struct PacketHead {
  std::uint32_t facet;  ///< number of the facet, < kMaxFacets; unique among packets of its layer
  glm::ivec3 lo, hi;
  Slab slab;
  Linear gap;  ///< of a voxel centre from the plane; see Claim for its unit, a, b, c at most one
  std::uint32_t first_side, side_count;
  Layer layer = Layer::armour;  ///< inside: the slab has no front, only 0 <= value counts
  Surface surface = Surface::solid;
};

/// Consecutive packets whose order among each other does not matter. Batches go one after another.
struct Batch {
  std::uint32_t first, count;
  /// After the last packet every column adds its parity to what is inside and starts anew, so
  /// that solids that overlap stay solid.
  bool ends_object;
};

struct PacketStream {
  std::vector<PacketHead> heads;
  std::vector<Side> sides;
  std::vector<Batch> batches;  ///< none: all packets are one batch
};

}  // namespace rc2::facet
