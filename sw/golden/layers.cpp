#include "sw/golden/layers.h"

#include "sw/golden/voxelise.h"
#include "sw/machine/claim.h"

namespace rc2::golden {

void Layers::clear() {
  bits_.clear();
  facing_.clear();
}

void Layers::note_facing(std::uint32_t facet, std::uint8_t facing) {
  if (facing_.size() <= facet) facing_.resize(facet + 1);
  facing_[facet] = facing;
}

void Layers::add(const Grid& grid, const facet::PacketHead& packet, const facet::Side* sides) {
  if (bits_.empty()) bits_.resize(static_cast<std::size_t>(n_) * n_ * n_);
  for_each_dexel(packet, sides, [&](const Dexel& dexel) {
    glm::ivec3 voxel = packet.lo + glm::ivec3(dexel.x, dexel.y, dexel.z.first);
    const int top = packet.layer == facet::Layer::inside
                        ? n_ - 1
                        : packet.lo.z + static_cast<int>(dexel.z.last);
    for (; voxel.z <= top; ++voxel.z) {
      if (packet.layer == facet::Layer::shown) at(voxel) |= kShown;
      if (packet.layer == facet::Layer::inside) at(voxel) ^= kParity;
      if (packet.layer != facet::Layer::thin) continue;
      const std::uint32_t owner = grid[grid.index(voxel)];
      if (owner == Grid::kFree) continue;
      if (facing_[Claim::unpacked(owner).facet] + packet.facing == kOppositeFacings) {
        at(voxel) |= kThin;
      }
    }
  });
}

void Layers::end_object() {
  for (std::uint8_t& bits : bits_) {
    if ((bits & kParity) != 0) bits = static_cast<std::uint8_t>((bits & ~kParity) | kInside);
  }
}

LayerMemory Layers::read(const Grid& grid) const {
  LayerMemory memory;
  std::size_t place = 0;
  for (glm::ivec3 at{0}; at.z < n_; ++at.z) {
    for (at.y = 0; at.y < n_; ++at.y) {
      for (at.x = 0; at.x < n_; ++at.x, ++place) {
        const bool armour = grid[grid.index(at)] != Grid::kFree;
        const unsigned bits = bits_.empty() ? 0 : bits_[place];
        const bool shown = (bits & kShown) != 0, inside = (bits & kInside) != 0;
        const bool thin = (bits & kThin) != 0;
        if (armour || shown || inside || thin) memory.push_back({at, armour, shown, inside, thin});
      }
    }
  }
  return memory;
}

}  // namespace rc2::golden
