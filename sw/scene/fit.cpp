#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "fmt/format.h"
#include "sw/base/error.h"
#include "sw/scene/scene.h"

namespace rc2::scene {

void fit_to_cube(Scene& scene, int n) {
  if (scene.vertices.empty())
    throw Error(
        fmt::format("{}: there is no polygon to fit into the cube; use a scene that has "
                    "some, or --fit none",
                    scene.name));
  glm::dvec3 low = scene.vertices.front(), high = low;
  for (const glm::dvec3& vertex : scene.vertices) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  const glm::dvec3 extent = high - low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double span = n < 4 ? n - 1 : n - 3;
  const double scale = span / longest;
  if (!(longest > 0.0) || !std::isfinite(longest) || !std::isfinite(scale))
    throw Error(
        fmt::format("{}: the scene cannot be fitted into the cube because its longest "
                    "side is {} units; give it a size that is neither zero nor infinite",
                    scene.name, longest));

  // Halved before they are added: the sum of two far corners may overflow.
  const glm::dvec3 middle = 0.5 * low + 0.5 * high;
  const glm::dvec3 centre(0.5 * (n - 1));
  const auto fit = [&](const glm::dvec3& p) { return (p - middle) * scale + centre; };
  for (glm::dvec3& vertex : scene.vertices) vertex = fit(vertex);
  for (Light& light : scene.lights) light.position = fit(light.position);
  if (scene.camera) scene.camera->position = fit(scene.camera->position);
}

}  // namespace rc2::scene
