// One bounce: how far what a machine's rays hit is from what they hit in truth.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sw/machine/ray_job.h"
#include "sw/truth/whitted.h"

namespace rc2 {

/// What became of rays from true points of the surface, mirrored where it mirrors and at random
/// everywhere.
struct Bounce {
  std::int64_t rays = 0;
  std::int64_t gross = 0;     ///< hit where nothing is or the reverse, or over 2 voxels apart
  std::int64_t early = 0;     ///< of these, those that ended too soon
  std::int64_t edges = 0;     ///< of these, those that passed an edge within half a voxel
  std::int64_t straight = 0;  ///< not gross, and reflected within a degree of the truth
  // Sums over those that are not gross.
  double distance = 0;  ///< voxels
  double degrees = 0;   ///< between the reflected ray and the true one
};

/// Follows the rays of a job.
using Trace = std::function<RayResult(const RayJob& job)>;

/// `trace` is through the scene in an n-cube. The points are those that a viewer in front sees; the
/// same in every run.
Bounce measure_bounce(const truth::Whitted& truth, const scene::Scene& scene,
                      const std::vector<rays::Facet>& optics, const Trace& trace, int n);

}  // namespace rc2
