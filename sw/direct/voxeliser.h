// A yardstick: how fast one thread of a CPU makes armoured voxels of triangles when nothing else is
// asked of it. No packets, no checks, no claims. It is there to be timed: no part of the machine
// depends on it, and it shares no code with what it is compared with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/ext/vector_int3_sized.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/scene/scene.h"

namespace rc2::direct {

class Voxeliser {
 public:
  static constexpr std::uint32_t kFree = 0xFFFFFFFF;

  /// An empty cube of n^3 voxels, 4 bytes each; vertices are rounded to 1/2^fraction_bits voxel.
  Voxeliser(int n, int fraction_bits);

  /// Adds the voxels of every polygon that is a triangle with its vertices in the cube; skips the
  /// others.
  void fill(const scene::Scene& scene);

  /// Lowest number, in scene order, of the polygons that hold the voxel; kFree if none does.
  std::uint32_t owner(const glm::ivec3& at) const {
    return owners_[static_cast<std::size_t>(at.x * stride_[0] + at.y * stride_[1] + at.z)];
  }

  std::int64_t voxel_count() const;

 private:
  using Vertex = glm::i64vec3;
  using Triangle = std::array<Vertex, 3>;

  // False if the corner is outside the cube.
  bool round(const glm::dvec3& corner, Vertex& vertex) const;
  void fill(const Triangle& p, std::uint32_t number);

  int n_, fraction_bits_;
  double one_, lowest_, end_;  // lowest_ <= 2^f * coordinate + 1/2 < end_
  std::array<std::ptrdiff_t, 3> stride_;
  std::vector<std::uint32_t> owners_;
};

}  // namespace rc2::direct
