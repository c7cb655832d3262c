// Rays by any of chapter 5's choices. Arithmetic of hits and reflections is the machine's
// (sw/rays), so that by the machine's choices they are the machine's rays, but for its safety net.
#pragma once

#include "sw/chapter5/voxels.h"

namespace rc2::chapter5 {

/// Follows each ray and those that come of it; no ray is rescued. `from_viewer`: the first rays are
/// a viewer's, who looks into the scene from outside; they stop by the machine's rule.
RayResult trace(const Voxels& voxels, const RayJob& job, const Choices& choices, bool from_viewer);

}  // namespace rc2::chapter5
