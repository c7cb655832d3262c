#include "sim/light_scenes.h"

#include <fmt/format.h>

#include <charconv>
#include <glm/common.hpp>

#include "sw/base/error.h"
#include "sw/scene/random.h"
#include "sw/scene/shapes.h"

namespace rc2 {
namespace {

using scene::Scene;

// Calls add(centre, axes) eight times: in the middles of the octants of a cube of 0.72 n, turned at
// random. Bodies within 0.18 n of their centres stay apart.
template <class Add>
void add_eight(int n, Add add) {
  scene::Random random(1);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 octant = 2.0 * glm::dvec3(i & 1, i >> 1 & 1, i >> 2) - 1.0;
    add(0.5 * (n - 1.0) + 0.18 * n * octant, scene::random_rotation(random));
  }
}

void add_boxes(Scene& scene, int n, const glm::dvec3& half_size) {
  add_eight(n, [&](const glm::dvec3& centre, const glm::dmat3& axes) {
    scene::add_box(scene, {centre, half_size, axes}, 0);
  });
}

void add_tori(Scene& scene, int n) {
  add_eight(n, [&](const glm::dvec3& centre, const glm::dmat3& axes) {
    scene::add_torus(scene, {centre, 0.12 * n, 0.05 * n, axes}, 0);
  });
}

void add_sheets(Scene& scene, int n) {
  add_eight(n, [&](const glm::dvec3& centre, const glm::dmat3& axes) {
    const glm::dvec3 u = 0.12 * n * axes[0], v = 0.12 * n * axes[1];
    scene.add({centre - u - v, centre + u - v, centre + u + v, centre - u + v}, 0);
  });
}

double thickness_of(const std::string& name) {
  const std::string word = name.substr(name.find(':') + 1);
  double thickness = 0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), thickness);
  if (failure != std::errc() || end != word.data() + word.size() ||
      !(thickness > 0 && thickness <= 8))
    throw Error(fmt::format(
        "{}: a plate cannot be '{}' voxels thick; write up to 8, for example plates:0.3", name,
        word));
  return thickness;
}

Scene fitted_file(const std::string& path, int n) {
  constexpr double kSize = 0.7;
  Scene scene = scene::read_file(path);
  scene::fit_to_cube(scene, n);
  const glm::dvec3 middle(0.5 * (n - 1));
  for (glm::dvec3& vertex : scene.vertices) vertex = middle + kSize * (vertex - middle);
  return scene;
}

}  // namespace

scene::Scene make_light_scene(const std::string& name, int n) {
  if (scene::is_generated_name(name)) return scene::generate(name, n);
  Scene scene;
  scene.name = name;
  scene.materials.resize(1);
  if (name == "sphere") {
    scene::add_sphere(scene, glm::dvec3(0.5 * (n - 1)), 0.3 * n, 0, 0);
  } else if (name == "boxes") {
    add_boxes(scene, n, static_cast<double>(n) * glm::dvec3(0.12, 0.1, 0.06));
  } else if (name == "tori") {
    add_tori(scene, n);
  } else if (name.rfind("plates:", 0) == 0) {
    add_boxes(scene, n, {0.12 * n, 0.12 * n, 0.5 * thickness_of(name)});
  } else if (name == "sheets") {
    add_sheets(scene, n);
  } else {
    return fitted_file(name, n);
  }
  return scene;
}

}  // namespace rc2
