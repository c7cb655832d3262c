// What voxels are part of beside their owner's armour.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/facet/packet.h"
#include "sw/golden/grid.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

/// Takes n^3 bytes once a packet of another layer than armour comes.
class Layers {
 public:
  explicit Layers(int n) : n_(n) {}

  void clear();

  /// Remembers which way a facet of the armour faces.
  void note_facing(std::uint32_t facet, std::uint8_t facing);

  /// What a packet of another layer does to the voxels it fills. `grid` holds the packed claims of
  /// all owners.
  void add(const Grid& grid, const facet::PacketHead& packet, const facet::Side* sides);

  /// The parity of the object that ends here becomes part of what is inside, and starts anew.
  void end_object();

  bool is_inside(const glm::ivec3& voxel) const { return has(voxel, kInside); }
  bool is_thin(const glm::ivec3& voxel) const { return has(voxel, kThin); }

  /// PacketHead::facing of a facet, 13 (no way) if it has no armour.
  int facing(std::uint32_t facet) const {
    return facet < facing_.size() ? facing_[facet] : kOppositeFacings / 2;
  }

  /// All voxels of any layer; `grid` tells which have armour.
  LayerMemory read(const Grid& grid) const;

 private:
  enum Bit : std::uint8_t { kShown = 1, kInside = 2, kThin = 4, kParity = 8 };

  std::size_t place(const glm::ivec3& voxel) const {
    return (static_cast<std::size_t>(voxel.z) * n_ + voxel.y) * n_ + voxel.x;
  }
  std::uint8_t& at(const glm::ivec3& voxel) { return bits_[place(voxel)]; }
  bool has(const glm::ivec3& voxel, Bit bit) const {
    return !bits_.empty() && (bits_[place(voxel)] & bit) != 0;
  }

  int n_;
  std::vector<std::uint8_t> bits_;
  std::vector<std::uint8_t> facing_;  // of each facet
};

}  // namespace rc2::golden
