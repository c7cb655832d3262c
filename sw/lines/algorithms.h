// The five line algorithms of chapter 2 side by side.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/lines/neighbourhood.h"

namespace rc2::lines {

struct Algorithm {
  const char* name;
  const char* section;     ///< of the thesis
  Adjacency connectivity;  ///< of consecutive voxels, as claimed
  /// Appends the voxels of the segment, from the first to the last.
  void (*draw)(glm::ivec3 from, glm::ivec3 to, std::vector<glm::ivec3>& voxels);
};

extern const std::array<Algorithm, 5> kAlgorithms;

}  // namespace rc2::lines
