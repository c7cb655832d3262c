// What the cells of a machine answer to a READ word, as beats of the readback stream
// (docs/host-port.md).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/machine/host_word.h"
#include "sw/machine/machine.h"

namespace rc2 {

class Readback {
 public:
  explicit Readback(const MachineConfig& config);

  /// A cell has something to say of a voxel; those of one cell come in order of z.
  void add(glm::ivec3 at, std::uint32_t value);

  /// The beats of each cell, y*n + x: at least one each.
  std::vector<std::vector<std::uint64_t>> beats() const;

 private:
  struct Said {
    int z;
    std::uint32_t value;
  };

  int n_;
  WordFormat format_;
  std::vector<std::vector<Said>> cells_;
};

/// {guard, inside, shown, armour}.
inline std::uint32_t packed_layers(const LayerRecord& voxel) {
  return (voxel.armour ? 1U : 0U) | (voxel.shown ? 2U : 0U) | (voxel.inside ? 4U : 0U) |
         (voxel.guard ? 8U : 0U);
}

inline LayerRecord unpacked_layers(glm::ivec3 at, std::uint32_t value) {
  const auto has = [value](int bit) { return (value >> bit & 1U) != 0; };
  return {at, has(0), has(1), has(2), has(3)};
}

/// The answers of a machine that holds these memories.
Readback readback_of(const MachineConfig& config, const VoxelMemory& voxels);
Readback readback_of(const MachineConfig& config, const LayerMemory& layers);
Readback readback_of(const MachineConfig& config, const VoxelMemory& voxels,
                     const LightMemory& light);

}  // namespace rc2
