// The n-cube of voxels inside a frame one voxel thick.
//
// A digital ray moves by at most one voxel per axis and step, so it cannot jump over the frame:
// one look at a voxel tells "free", "occupied" and "outside" apart, with no coordinates to compare.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rc2::golden {

class Grid {
 public:
  // What a voxel holds; any other value is a number given to an occupied voxel.
  static constexpr std::uint32_t kFree = 0xFFFFFFFF;
  static constexpr std::uint32_t kOutside = 0xFFFFFFFE;

  /// An empty cube of n x n x n voxels.
  explicit Grid(int n)
      : n_(n),
        stride_{1, n + 2, static_cast<std::ptrdiff_t>(n + 2) * (n + 2)},
        voxels_(static_cast<std::size_t>(stride_[2] * (n + 2)), kOutside) {
    clear();
  }

  /// Frees every voxel inside the frame.
  void clear() {
    for (int z = 0; z < n_; ++z) {
      for (int y = 0; y < n_; ++y) {
        const auto row = voxels_.begin() + index({0, y, z});
        std::fill(row, row + n_, kFree);
      }
    }
  }

  int n() const { return n_; }

  /// Places of the cube and its frame.
  std::size_t size() const { return voxels_.size(); }

  /// Distance in memory between two neighbours along axis 0, 1 or 2.
  std::ptrdiff_t stride(int axis) const { return stride_[static_cast<std::size_t>(axis)]; }

  /// Place of a voxel, each coordinate in -1 .. n (-1 and n are the frame).
  std::ptrdiff_t index(glm::ivec3 at) const {
    return (at.x + 1) * stride_[0] + (at.y + 1) * stride_[1] + (at.z + 1) * stride_[2];
  }

  std::uint32_t& operator[](std::ptrdiff_t place) {
    return voxels_[static_cast<std::size_t>(place)];
  }
  std::uint32_t operator[](std::ptrdiff_t place) const {
    return voxels_[static_cast<std::size_t>(place)];
  }

 private:
  int n_;
  std::array<std::ptrdiff_t, 3> stride_;
  std::vector<std::uint32_t> voxels_;
};

}  // namespace rc2::golden
