// What each voxel does to the rays of one light: the masks that a column keeps for it.
#pragma once

#include <cstdint>
#include <vector>

#include "sw/golden/grid.h"
#include "sw/golden/layers.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

enum class Matter : std::uint8_t {
  outside,  ///< of the cube: ends a ray
  free,
  solid,  ///< ends a ray, and there is nothing to light
  stop,   ///< is lit and ends a ray
  pass    ///< is lit and passed
};

constexpr bool is_lit(Matter matter) { return matter >= Matter::stop; }
constexpr bool ends_light(Matter matter) {
  return matter == Matter::solid || matter == Matter::stop;
}

/// One light's view of all voxels, by their places in the grid, which holds the numbers of the
/// occupied voxels in `voxels`. docs/light.md words the rules.
std::vector<Matter> look_from(const LightJob& job, const Grid& grid, const VoxelMemory& voxels,
                              const Layers& layers);

}  // namespace rc2::golden
