#include "sw/surface/closed_meshes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "sw/scene/shapes.h"

namespace rc2::surface {
namespace {

using scene::Random;
using scene::Scene;

constexpr int kSmall = 32, kMiddle = 48, kLarge = 64;

// Braces evaluate from left to right; a call of the constructor would not have to.
glm::dvec3 random_vector(Random& random, double low, double high) {
  return glm::dvec3{random.between(low, high), random.between(low, high),
                    random.between(low, high)};
}

// Near the middle of the cube, in no special place of the grid.
glm::dvec3 random_centre(Random& random, int n) {
  return 0.5 * (n - 1) + random_vector(random, -1, 1);
}

void add_tetrahedron(Scene& scene, Random& random) {
  constexpr double kLeastVolume = 100;  // voxels
  for (;;) {
    std::array<glm::dvec3, 4> corners;
    for (glm::dvec3& corner : corners) corner = random_vector(random, 1, kSmall - 2);
    const glm::dvec3 sides = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (std::abs(glm::dot(sides, corners[3] - corners[0])) < 6 * kLeastVolume) continue;
    scene::add_tetrahedron(scene, corners, 0);
    return;
  }
}

// One to two voxels thick: two opposite edges, above and below a plane.
void add_flat_tetrahedron(Scene& scene, Random& random) {
  const glm::dmat3 axes = scene::random_rotation(random);
  const glm::dvec3 centre = random_centre(random, kMiddle);
  const double reach = 0.3 * kMiddle;
  std::array<glm::dvec3, 4> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    glm::dvec3 at = random_vector(random, -reach, reach);
    at.z = random.between(0.5, 1) * (i < 2 ? 1 : -1);
    corners[i] = centre + axes * at;
  }
  scene::add_tetrahedron(scene, corners, 0);
}

// 1280 triangles.
void add_sphere(Scene& scene, Random& random) {
  const double radius = random.between(0.2 * kLarge, 0.45 * kLarge);
  scene::add_sphere(scene, random_centre(random, kLarge), radius, 0.13 * radius, 0);
}

void add_torus(Scene& scene, Random& random) {
  const double ring = random.between(0.2 * kLarge, 0.3 * kLarge);
  const double tube = random.between(0.05 * kLarge, 0.14 * kLarge);
  const glm::dmat3 axes = scene::random_rotation(random);
  scene::add_torus(scene, {random_centre(random, kLarge), ring, tube, axes}, 0);
}

void add_box(Scene& scene, Random& random) {
  const glm::dvec3 half_size = random_vector(random, 0.06 * kMiddle, 0.22 * kMiddle);
  const glm::dmat3 axes = scene::random_rotation(random);
  scene::add_box(scene, {random_centre(random, kMiddle), half_size, axes}, 0);
}

// One to three voxels thick.
void add_plate(Scene& scene, Random& random) {
  glm::dvec3 half_size = random_vector(random, 0.1 * kMiddle, 0.28 * kMiddle);
  half_size.z = random.between(0.5, 1.5);
  const glm::dmat3 axes = scene::random_rotation(random);
  scene::add_box(scene, {random_centre(random, kMiddle), half_size, axes}, 0);
}

// Faces at multiples of half a voxel: through voxel centres, or half-way between them.
void add_axis_box(Scene& scene, Random& random) {
  glm::dvec3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = 0.5 * (2 + random.below(kMiddle));
    high[axis] = low[axis] + 0.5 * (4 + random.below(kMiddle - 10));
  }
  scene::add_box(scene, {0.5 * (low + high), 0.5 * (high - low)}, 0);
}

}  // namespace

const std::vector<MeshFamily> kMeshFamilies = {
    {"tetrahedra", kSmall, add_tetrahedron},
    {"flat tetrahedra", kMiddle, add_flat_tetrahedron},
    {"spheres", kLarge, add_sphere},
    {"tori", kLarge, add_torus},
    {"boxes", kMiddle, add_box},
    {"plates", kMiddle, add_plate},
    {"axis boxes", kMiddle, add_axis_box},
};

Scene make_mesh(const MeshFamily& family, std::uint64_t seed) {
  Scene scene;
  scene.name = family.name + std::string(":") + std::to_string(seed);
  scene.materials.resize(1);
  Random random(seed);
  family.add(scene, random);
  return scene;
}

}  // namespace rc2::surface
