#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace rc2::surface {

/// One value for each voxel of an n-cube, x fastest, z slowest.
template <class Value>
class VoxelArray {
 public:
  explicit VoxelArray(int n) : n_(n), values_(static_cast<std::size_t>(n) * n * n) {}

  int n() const { return n_; }
  bool contains(const glm::ivec3& at) const { return glm::clamp(at, 0, n_ - 1) == at; }

  Value& operator[](const glm::ivec3& at) { return values_[index(at)]; }
  const Value& operator[](const glm::ivec3& at) const { return values_[index(at)]; }

  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::size_t index(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * n_ + at.y) * n_ + at.x;
  }

  int n_;
  std::vector<Value> values_;
};

/// A set of voxels: 1 for those that belong to it. Bytes, because vector<bool> is slow.
using VoxelSet = VoxelArray<std::uint8_t>;

/// Whether the point lies in a voxel of the set, or no farther than `near` along each axis from
/// one: what is on a border may belong to either side.
inline bool covers(const VoxelSet& voxels, const glm::dvec3& point, double near) {
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 way = 2.0 * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) - 1.0;
    const glm::ivec3 voxel(glm::floor(point + near * way + 0.5));
    if (voxels.contains(voxel) && voxels[voxel] != 0) return true;
  }
  return false;
}

}  // namespace rc2::surface
