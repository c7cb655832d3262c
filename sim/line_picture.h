#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sw/picture/raster.h"

namespace rc2 {

/// Drawings of the same segment as rows of cubes seen from (1,1,1), one panel each with the true
/// segment over it, in the order given. Voxels that the first drawing has are blue, others orange.
picture::Raster draw_lines(glm::ivec3 from, glm::ivec3 to,
                           const std::vector<std::vector<glm::ivec3>>& drawings);

}  // namespace rc2
