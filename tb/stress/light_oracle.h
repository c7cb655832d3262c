// What a light must do to the voxels of a cube, ray by ray, from the definitions alone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sw/facet/facet.h"
#include "sw/machine/machine.h"

namespace rc2::stress {

/// Voxels i of a ray that light reaches are 0 .. count-1; the last of them may end it.
struct Reach {
  std::size_t count;
  bool is_home;
};

struct ExpectedLight {
  LightMemory arrived;  ///< in the order of VoxelMemory
  TargetCount targets;
  std::int64_t visits = 0;  ///< voxels that rays looked at
  std::int64_t passed = 0;  ///< of them, armoured ones that a ray went on from
};

/// Rays are the closed formula of thesis 4.3.1, not a line algorithm; targets are the points of the
/// surface of the cube of half-side L, whatever face they are on. Rules are as docs/light.md words
/// them, on one whole ray at a time. Rays with the same voxels are followed once, so that L may be
/// as large as a machine takes it.
class LightOracle {
 public:
  /// `packets` tell which way facets face.
  LightOracle(int n, const VoxelMemory& voxels, const LayerMemory& layers,
              const facet::PacketStream& packets);

  /// The light of a job; its source must be free.
  ExpectedLight light(const LightJob& job) const;

  bool is_armoured(const glm::ivec3& at) const { return at_voxel(at).armour; }
  bool is_inside(const glm::ivec3& at) const { return at_voxel(at).inside; }

 private:
  struct Voxel {
    bool armour = false, inside = false, thin = false;
    std::uint32_t number = 0;  ///< in the order of VoxelMemory
    Claim owner;
  };
  using Ray = std::vector<glm::ivec3>;

  const Voxel& at_voxel(const glm::ivec3& at) const {
    return voxels_[(static_cast<std::size_t>(at.z) * n_ + at.y) * n_ + at.x];
  }
  Voxel& at_voxel(const glm::ivec3& at) {
    return voxels_[(static_cast<std::size_t>(at.z) * n_ + at.y) * n_ + at.x];
  }
  Reach reach(const Ray& ray, const LightJob& job) const;
  // The last thin voxel before voxel i of the ray.
  std::optional<std::size_t> last_thin(const Ray& ray, std::size_t i) const;
  bool was_behind(const Ray& ray, std::size_t i, const LightJob& job) const;
  bool came_through(const Ray& ray, std::size_t i, const LightJob& job) const;

  int n_;
  std::size_t count_;
  std::vector<Voxel> voxels_;
  std::vector<int> facing_;
};

}  // namespace rc2::stress
