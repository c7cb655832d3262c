// What a light must do to the voxels of a cube, ray by ray, from the definitions alone.
#pragma once

#include <cstdint>
#include <vector>

#include "sw/facet/facet.h"
#include "sw/machine/machine.h"
#include "tb/stress/stop_oracle.h"

namespace rc2::stress {

struct ExpectedLight {
  LightMemory arrived;  ///< in the order of VoxelMemory
  TargetCount targets;
  std::int64_t visits = 0;   ///< voxels that rays looked at
  std::int64_t passed = 0;   ///< of them, armoured ones that a ray went on from
  std::int64_t guarded = 0;  ///< of them, those not armoured that ended a ray
};

/// Rays are the closed formula of thesis 4.3.1, not a line algorithm; targets are the points of the
/// surface of the cube of half-side L, whatever face they are on. Rays with the same voxels are
/// followed once, so that L may be as large as a machine takes it.
class LightOracle {
 public:
  /// `packets` are all that was loaded.
  LightOracle(int n, const VoxelMemory& voxels, const LayerMemory& layers,
              const facet::PacketStream& packets);

  /// The light of a job; its source must be free.
  ExpectedLight light(const LightJob& job) const;

  bool is_armoured(const glm::ivec3& at) const { return at_voxel(at).armour; }
  bool is_inside(const glm::ivec3& at) const { return at_voxel(at).inside; }

 private:
  struct Voxel {
    bool armour = false, inside = false;
    std::uint32_t number = 0;  ///< in the order of VoxelMemory
  };
  using Ray = std::vector<glm::ivec3>;

  std::size_t place(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * n_ + at.y) * n_ + at.x;
  }
  const Voxel& at_voxel(const glm::ivec3& at) const { return voxels_[place(at)]; }
  Voxel& at_voxel(const glm::ivec3& at) { return voxels_[place(at)]; }
  // Of each voxel, whether it ends the job's rays.
  std::vector<bool> find_stops(const LightJob& job) const;

  int n_;
  std::size_t count_;
  std::vector<Voxel> voxels_;
  StopOracle accurate_;
};

}  // namespace rc2::stress
