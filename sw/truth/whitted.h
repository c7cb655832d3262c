// The picture of the continuous scene: Whitted's recursive ray tracing (thesis 1.1) of the mesh as
// it was read.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sw/rays/ray.h"
#include "sw/scene/smooth.h"
#include "sw/truth/surface.h"

namespace rc2::truth {

/// A point light.
struct Lamp {
  glm::dvec3 at;
  glm::vec3 colour;
  bool casts_shadows = true;
};

class Whitted {
 public:
  /// `bodies` says of each polygon what it belongs to; n is the side of the cube, by which light
  /// fades. Surfaces are shaded by `smooth` normals, by their own if there are none; rays are
  /// always reflected by their own. All must outlive this.
  Whitted(const scene::Scene& scene, std::vector<rays::Body> bodies, int n,
          const scene::SmoothNormals* smooth = nullptr);

  struct Hit {
    glm::dvec3 at;
    glm::dvec3 normal;  ///< unit, turned towards the ray
    std::uint32_t polygon;
    bool is_back;
  };

  /// What the ray meets first: a ray in air does not see a solid or a room from behind; a ray in
  /// glass sees glass only from behind. Double precision: Embree names the triangle, and the hit
  /// is where the ray meets its plane.
  std::optional<Hit> first_hit(const glm::dvec3& from, const glm::dvec3& direction,
                               bool inside) const;

  /// What comes along the ray, with so many bounces at most. Linear RGB.
  glm::vec3 colour(const glm::dvec3& from, const glm::dvec3& direction,
                   const std::vector<Lamp>& lamps, int depth, bool inside = false) const;

 private:
  bool is_glass(std::uint32_t polygon) const;
  glm::vec3 shade(const Hit& hit, const glm::dvec3& direction,
                  const std::vector<Lamp>& lamps) const;

  const scene::Scene& scene_;
  std::vector<rays::Body> bodies_;
  int n_;
  const scene::SmoothNormals* smooth_;
  Surface surface_;
};

/// Snell's law in air and glass, `ratio` being the refractive index before the surface over that
/// behind it; none if all light is reflected. Unit vectors, the normal towards the ray.
std::optional<glm::dvec3> refract(const glm::dvec3& direction, const glm::dvec3& normal,
                                  double ratio);

}  // namespace rc2::truth
