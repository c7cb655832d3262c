// Rays that are followed one after another: from the objects to the light, or from the light.
#pragma once

#include <vector>

#include "sw/emission/ledger.h"
#include "sw/machine/machine.h"

namespace rc2::emission {

/// Objects to sources (4.1.2): each voxel sends a digital ray to the source's, which comes back as
/// an answer from the source or from the first occupied voxel on the way.
void ask_light(Ledger& ledger, const std::vector<glm::ivec3>& voxels, const glm::ivec3& source);

/// Which rays a source sends.
enum class Targets {
  voxels,   ///< one to every other voxel of the cube (4.1.4)
  border,   ///< one to every other voxel on the surface of the cube (4.1.4, figure 4.6)
  virtual_  ///< one to every target of the virtual faces at distance n - 1 (4.3.4)
};

/// Sources to objects, one after another (4.2.4): a ray ends in the first occupied voxel and lights
/// it, or at its target.
void send_one_by_one(Ledger& ledger, Targets targets, const glm::ivec3& source);

}  // namespace rc2::emission
