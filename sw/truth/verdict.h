// Which voxels are lit in the continuous scene.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sw/truth/samples.h"

namespace rc2::truth {

/// What the surface in a voxel says, by the majority of its samples. A sample is buried, and does
/// not count, if more solids go round it than round the light. It faces the light if it is on the
/// side of the light of its triangle, and is lit if besides nothing is in between.
struct Verdict {
  bool exposed;         ///< any sample is not buried
  bool faces_light;     ///< half or more of the exposed ones face the light
  bool facing_are_lit;  ///< half or more of those that face it are lit
  bool lit;             ///< half or more of the exposed ones are lit
  bool seen;            ///< any exposed one is seen by the viewer
};

/// The verdicts on the voxels, in their order. Where a voxel has less than kFewest samples, the
/// point of the surface nearest to its centre decides.
std::vector<Verdict> judge(const Surface& surface, const Samples& samples,
                           const std::vector<glm::ivec3>& voxels, const glm::dvec3& light);

constexpr int kFewest = 3;

}  // namespace rc2::truth
