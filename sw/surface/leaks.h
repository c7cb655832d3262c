// How well each discretiser's voxels separate the inside of a closed mesh from its outside.
#pragma once

#include <array>

#include "sw/surface/discretise.h"
#include "sw/surface/tunnels.h"

namespace rc2::surface {

struct Leaks {
  std::int64_t voxels = 0;
  Tunnels tunnels;
};

/// One for each of kDiscretisers, in their order.
using LeakRow = std::array<Leaks, kDiscretisers.size()>;

/// Each discretiser is measured against the mesh that it was given, with vertices rounded to its
/// own fraction bits. Throws Error if the scene (voxel coordinates) is not closed, or as
/// discretise.
LeakRow find_leaks(const scene::Scene& scene, int n);

}  // namespace rc2::surface
