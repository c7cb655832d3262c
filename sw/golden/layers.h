// What voxels are part of beside their owner's armour.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sw/facet/packet.h"
#include "sw/golden/grid.h"
#include "sw/machine/claim.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

/// The plane of a facet, as a voxel that it owns has it.
struct Plane {
  glm::ivec3 normal{0};  ///< rc2::normal_of
  facet::Surface surface = facet::Surface::solid;
};

/// Takes n^3 bytes once a packet of another layer than armour comes, and 4 n^3 for a guard.
class Layers {
 public:
  explicit Layers(int n) : n_(n) {}

  void clear();

  /// Remembers the plane of a facet.
  void note_plane(const facet::PacketHead& packet);

  /// What a packet of another layer does to the voxels it fills. `grid` holds the packed claims of
  /// all owners.
  void add(const Grid& grid, const facet::PacketHead& packet, const facet::Side* sides);

  /// The parity of the object that ends here becomes part of what is inside, and starts anew.
  void end_object();

  bool is_inside(const glm::ivec3& voxel) const { return has(voxel, kInside); }

  /// Of a facet with armour or a guard.
  const Plane& plane(std::uint32_t facet) const { return planes_[facet]; }

  /// The best claim of a guard to a voxel that is not occupied.
  std::optional<Claim> guard(const glm::ivec3& voxel) const;

  /// All voxels of any layer; `grid` tells which have armour.
  LayerMemory read(const Grid& grid) const;

 private:
  enum Bit : std::uint8_t { kShown = 1, kInside = 2, kParity = 4 };

  std::size_t place(const glm::ivec3& voxel) const {
    return (static_cast<std::size_t>(voxel.z) * n_ + voxel.y) * n_ + voxel.x;
  }
  std::uint8_t& at(const glm::ivec3& voxel) { return bits_[place(voxel)]; }
  bool has(const glm::ivec3& voxel, Bit bit) const {
    return !bits_.empty() && (bits_[place(voxel)] & bit) != 0;
  }

  int n_;
  std::vector<std::uint8_t> bits_;
  std::vector<std::uint32_t> guard_;  // packed claims, or Grid::kFree
  std::vector<Plane> planes_;         // of each facet
};

}  // namespace rc2::golden
