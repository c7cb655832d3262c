#include "sw/golden/layers.h"

#include <algorithm>

#include "sw/golden/voxelise.h"
#include "sw/machine/plane.h"

namespace rc2::golden {

void Layers::clear() {
  bits_.clear();
  guard_.clear();
  planes_.clear();
}

void Layers::note_plane(const facet::PacketHead& packet) {
  if (planes_.size() <= packet.facet) planes_.resize(packet.facet + 1);
  planes_[packet.facet] = {normal_of(packet.gap), packet.surface};
}

void Layers::add(const Grid& grid, const facet::PacketHead& packet, const facet::Side* sides) {
  const auto cube = static_cast<std::size_t>(n_) * n_ * n_;
  if (bits_.empty()) bits_.resize(cube);
  const bool is_guard = packet.layer == facet::Layer::guard;
  if (is_guard && guard_.empty()) guard_.resize(cube, Grid::kFree);
  for_each_dexel(packet, sides, [&](const Dexel& dexel) {
    glm::ivec3 voxel = packet.lo + glm::ivec3(dexel.x, dexel.y, dexel.z.first);
    const int top = packet.layer == facet::Layer::inside
                        ? n_ - 1
                        : packet.lo.z + static_cast<int>(dexel.z.last);
    for (; voxel.z <= top; ++voxel.z) {
      if (packet.layer == facet::Layer::shown) at(voxel) |= kShown;
      if (packet.layer == facet::Layer::inside) at(voxel) ^= kParity;
      if (!is_guard || grid[grid.index(voxel)] != Grid::kFree) continue;
      std::uint32_t& best = guard_[place(voxel)];
      best = std::min(best, claim_of(n_, packet, dexel, voxel.z - packet.lo.z).packed());
    }
  });
}

std::optional<Claim> Layers::guard(const glm::ivec3& voxel) const {
  if (guard_.empty() || guard_[place(voxel)] == Grid::kFree) return {};
  return Claim::unpacked(guard_[place(voxel)]);
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
        const bool guard = !guard_.empty() && guard_[place] != Grid::kFree;
        if (armour || shown || inside || guard)
          memory.push_back({at, armour, shown, inside, guard});
      }
    }
  }
  return memory;
}

}  // namespace rc2::golden
