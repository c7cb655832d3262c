// One bounce: how far what a machine's rays hit is from what they hit in truth.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/drive.h"
#include "sw/truth/whitted.h"

namespace rc2 {

/// What became of rays from true points of the surface, mirrored where it mirrors and at random
/// everywhere.
struct Bounce {
  std::int64_t rays = 0;
  std::int64_t gross = 0;     ///< hit where nothing is or the reverse, or over 2 voxels apart
  std::int64_t early = 0;     ///< of these, those that ended too soon
  std::int64_t straight = 0;  ///< not gross, and reflected within a degree of the truth
  double distance = 0;        ///< sum over those that are not gross, voxels
};

/// `drive` has loaded the scene into an n-cube. The points are those that a viewer in front sees;
/// the same in every run.
Bounce measure_bounce(const truth::Whitted& truth, const scene::Scene& scene,
                      const std::vector<rays::Facet>& optics, Drive& drive, int n);

}  // namespace rc2
