// Normals that change gently over a mesh (Gouraud, Phong): for the first picture (thesis 1.3.2).
#pragma once

#include <vector>

#include "sw/scene/scene.h"

namespace rc2::scene {

class SmoothNormals {
 public:
  /// The scene must outlive this.
  explicit SmoothNormals(const Scene& scene);

  /// Unit vector: those at the corners of a convex polygon, interpolated at a place in it; beyond a
  /// side, that on the side. A corner's normal is the scene's, unless that is none or one of the
  /// back: then the mean of those of the polygons that meet there, as far as they are within 45
  /// degrees of this one's, so that sharper edges stay sharp.
  glm::dvec3 at(std::uint32_t polygon, const glm::dvec3& place) const;

 private:
  const Scene& scene_;
  std::vector<glm::dvec3> corners_;  // by index into the scene's vertices
  std::vector<glm::dvec3> flat_;     // of each polygon
};

}  // namespace rc2::scene
