// A picture with all that is known of each pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rc2::picture {

/// n x n pixels. Every channel holds them row by row; row 0 is the top, y = n-1.
struct Image {
  static constexpr std::uint32_t kNoFacet = 0xFFFFFFFF;

  int n = 0;
  std::vector<glm::vec3> colour;     ///< linear RGB; the background where nothing is seen
  std::vector<float> depth;          ///< voxels, to what is seen (render and compose say from where
                                     ///< to where); infinite where nothing is
  std::vector<glm::vec3> normal;     ///< unit, turned towards the viewer; 0 where there is none
  std::vector<std::uint32_t> facet;  ///< owner of the voxel seen, or kNoFacet
  std::vector<std::vector<std::uint32_t>> lights;  ///< per lamp: targets that arrived there

  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(n - 1 - y) * static_cast<std::size_t>(n) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace rc2::picture
