#pragma once

#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace rc2::peers {

/// A bit for each voxel of an n-cube.
class BitGrid {
 public:
  explicit BitGrid(int n) : n_(n), bits_(static_cast<std::size_t>(n) * n * n) {}

  int n() const { return n_; }
  bool contains(const glm::ivec3& at) const { return glm::clamp(at, 0, n_ - 1) == at; }
  bool at(const glm::ivec3& at) const { return bits_[place(at)]; }
  void set(const glm::ivec3& at) { bits_[place(at)] = true; }

 private:
  std::size_t place(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * n_ + at.y) * n_ + at.x;
  }

  int n_;
  std::vector<bool> bits_;
};

}  // namespace rc2::peers
