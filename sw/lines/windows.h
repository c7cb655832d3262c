#pragma once

#include "sw/lines/tunnels.h"

namespace rc2::lines {

/// A set of voxels of a window of `size` voxels; bit (z size.y + y) size.x + x tells whether voxel
/// (x,y,z) belongs to it.
struct WindowSet {
  glm::ivec3 size;
  std::uint32_t bits;

  bool has(glm::ivec3 at) const;
  int count() const;
};

/// Every set of voxels of a window that stops 6-connected rays from its top (largest z) to its
/// bottom, by the thesis's connectivity of the set (2.1). To stop those rays is what makes it a
/// surface here: the definition of the thesis asks less, even the empty set satisfies it.
/// A window with size.y = 1 is a plane. At most 24 voxels; 18 take a second.
TunnelTable<WindowSet> search_window(glm::ivec3 size);

}  // namespace rc2::lines
