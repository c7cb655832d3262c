// What a ray becomes where it hits: at most a reflected and a refracted one (thesis 1.1).
#pragma once

#include <optional>

#include "sw/rays/face.h"
#include "sw/rays/ray.h"

namespace rc2::rays {

/// When a branch of a pixel's tree ends (thesis 1.2.5.1).
struct Limits {
  int depth;         ///< bounces, 0 .. kMaxDepth
  int least_weight;  ///< of a ray that is worth following, of kWeightOne
};

/// The rays that a hit sends out, and how many more it would have without the limits.
struct Split {
  std::optional<Ray> reflected, refracted;
  int too_light = 0, too_deep = 0;
};

/// The rays from a hit at `point`. Glass that is a solid bends the ray; what it totally reflects
/// adds to the mirror's share. Through a clear sheet or room it goes straight on.
Split split(const Ray& ray, const Facet& facet, const Face& face, const glm::ivec3& point,
            const Limits& limits, int n);

/// The mirrored direction. One division.
glm::ivec3 reflect(const glm::ivec3& direction, const Face& face, int n);

/// The direction behind the face by Snell's law, `ratio` being the refractive index before it over
/// that behind it, of kIndexOne; none if all is reflected. One division, one square root.
std::optional<glm::ivec3> refract(const glm::ivec3& direction, const Face& face, int ratio, int n);

}  // namespace rc2::rays
