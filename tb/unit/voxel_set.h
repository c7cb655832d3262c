// Packets as sets of voxels, by looking at every voxel of every box.
#pragma once

#include <vector>

#include "sw/facet/packet.h"

namespace rc2::facet {

inline std::int64_t value_at(const Linear& value, const glm::ivec3& at) {
  return value.a * at.x + value.b * at.y + value.c * at.z + value.d;
}

inline bool is_inside(const PacketStream& stream, const PacketHead& head, const glm::ivec3& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < head.lo[axis] || p[axis] > head.hi[axis]) return false;
  const glm::ivec3 at = p - head.lo;
  const std::int64_t height = value_at(head.slab.value, at);
  if (height < 0 || height > head.slab.width) return false;
  for (std::uint32_t i = 0; i < head.side_count; ++i)
    if (value_at(stream.sides[head.first_side + i].value, at) < 0) return false;
  return true;
}

class VoxelSet {
 public:
  VoxelSet(const PacketStream& stream, int n) : n_(n), bits_(static_cast<std::size_t>(n) * n * n) {
    for (const PacketHead& head : stream.heads)
      for (int z = head.lo.z; z <= head.hi.z; ++z)
        for (int y = head.lo.y; y <= head.hi.y; ++y)
          for (int x = head.lo.x; x <= head.hi.x; ++x)
            if (is_inside(stream, head, {x, y, z})) bits_[index({x, y, z})] = true;
  }

  bool has(const glm::ivec3& p) const { return bits_[index(p)]; }

  std::size_t count() const {
    std::size_t result = 0;
    for (const bool bit : bits_) result += bit;
    return result;
  }

 private:
  std::size_t index(const glm::ivec3& p) const {
    return (static_cast<std::size_t>(p.z) * n_ + p.y) * n_ + p.x;
  }

  int n_;
  std::vector<bool> bits_;
};

}  // namespace rc2::facet
