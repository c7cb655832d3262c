// A scene's voxels with the owner that a choice gives them.
#pragma once

#include <vector>

#include "sw/chapter5/choices.h"
#include "sw/facet/packet.h"
#include "sw/golden/grid.h"
#include "sw/machine/machine.h"
#include "sw/rays/ray.h"

namespace rc2::chapter5 {

class Voxels {
 public:
  /// Those of the armour. `facets` are those of the packets.
  Voxels(const facet::PacketStream& packets, const std::vector<rays::Facet>& facets, int n,
         Owner owner);

  int n() const { return grid_.n(); }

  /// Of a voxel of the cube; null if it is free.
  const VoxelRecord* find(const glm::ivec3& voxel) const {
    const std::uint32_t number = grid_[grid_.index(voxel)];
    return number == golden::Grid::kFree ? nullptr : &memory_[number];
  }

  /// The mean of the normals of all facets that fill an occupied voxel, in slope form.
  const glm::ivec3& mean_normal(const VoxelRecord& voxel) const {
    return means_[static_cast<std::size_t>(&voxel - memory_.data())];
  }

  const VoxelMemory& memory() const { return memory_; }

 private:
  golden::Grid grid_;  // numbers
  VoxelMemory memory_;
  std::vector<glm::ivec3> means_;
};

}  // namespace rc2::chapter5
