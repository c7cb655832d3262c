// What slabs of few bits do to the voxels of a scene.
#pragma once

#include <cstdint>
#include <optional>

#include "sw/surface/rounding.h"
#include "sw/surface/tunnels.h"
#include "sw/surface/voxel_array.h"

namespace rc2::surface {

struct RoundingError {
  std::int64_t missing = 0;  ///< voxels of the exact slabs that are not in the rounded ones
  std::int64_t extra = 0;    ///< the other way round
  Tunnels tunnels;           ///< none are counted if the scene is not closed
};

/// A scene in the golden machine under the armoured rule, its facets exact and rounded.
class RoundingTrial {
 public:
  /// The scene is in voxel coordinates, all of it inside the n-cube; vertices get the machine's
  /// default fraction bits. Throws Error as facet::build_facets does.
  RoundingTrial(const scene::Scene& scene, int n);

  std::int64_t facets() const { return static_cast<std::int64_t>(packets_.heads.size()); }
  std::int64_t voxels() const { return voxels_; }

  /// `bits` as in round_slabs.
  RoundingError measure(int bits, Rounding rounding) const;

 private:
  Mesh mesh_;
  facet::PacketStream packets_;
  VoxelSet exact_;
  std::int64_t voxels_;
  std::optional<VoxelArray<std::int32_t>> winding_;  ///< if the scene is closed
};

}  // namespace rc2::surface
