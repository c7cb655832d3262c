// The scene's polygons as triangles, where they are: nothing is rounded.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/scene/scene.h"

namespace rc2::truth {

struct Triangles {
  std::vector<glm::dvec3> vertices;    ///< those of the scene
  std::vector<glm::uvec3> corners;     ///< of each triangle, outside counter-clockwise
  std::vector<std::uint32_t> polygon;  ///< of each triangle

  /// Twice its area, along its outward normal.
  glm::dvec3 doubled_area(std::size_t triangle) const;
};

/// Cuts the polygons up. Concave polygons are cut where facet::triangulate cuts them.
Triangles triangles_of(const scene::Scene& scene);

}  // namespace rc2::truth
