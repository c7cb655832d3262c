// What each voxel does to the rays of one light: the masks that a column would keep for it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/golden/grid.h"
#include "sw/golden/layers.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

enum class Matter : std::uint8_t {
  outside,  ///< of the cube: ends a ray
  free,     ///< ends a ray that went into something thin
  solid,    ///< ends a ray, and there is nothing to light
  stop,     ///< is lit and ends a ray
  pass,     ///< is lit and passed, unless the ray went through something thin
  front,    ///< of something thin, on the light's side: is lit and passed
  back      ///< of something thin, on the far side: is lit and passed
};

/// What a ray remembers on its way: two bits, which the thesis's rule has no need of.
class Passage {
 public:
  bool ends_in(Matter matter) const {
    switch (matter) {
      case Matter::free:
        return wall_ != Wall::none;
      case Matter::pass:
        return wall_ == Wall::crossed;
      case Matter::front:
      case Matter::back:
        return false;
      default:
        return true;
    }
  }

  /// The ray goes on from this voxel by `step`. `to_light` is the way to the light's side of the
  /// voxel's owner, its large components only. Armour is as thick as the longest step, half of it
  /// in front: a ray can leap to behind it. It did if it went towards the facet into a free voxel.
  void leave(Matter matter, const glm::ivec3& to_light, const glm::ivec3& step) {
    if (matter == Matter::back) wall_ = Wall::crossed;
    if (matter != Matter::front) return;
    const glm::ivec3 product = to_light * step;
    wall_ = product.x + product.y + product.z < 0 ? Wall::entered : Wall::none;
  }

 private:
  enum class Wall : std::uint8_t { none, entered, crossed };
  Wall wall_ = Wall::none;
};

/// One light's view of the cube.
struct Field {
  std::vector<Matter> matter;        ///< of all voxels, by their places in the grid
  std::vector<glm::ivec3> to_light;  ///< of each facet, see Passage; none by the thesis's rule
};

/// `grid` holds the numbers of the occupied voxels in `voxels`.
Field look_from(const LightJob& job, const Grid& grid, const VoxelMemory& voxels,
                const Layers& layers);

}  // namespace rc2::golden
