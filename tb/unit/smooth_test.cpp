// Normals that change gently over a mesh, where geometry knows them.
#include "sw/scene/smooth.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sw/scene/shapes.h"

namespace rc2::scene {
namespace {

const glm::dvec3 kMiddle(20, 21, 22);

Scene sphere() {
  Scene scene;
  scene.materials.resize(1);
  add_sphere(scene, kMiddle, 10, 2, 0);
  return scene;
}

glm::dvec3 flat_normal(const Scene& scene, std::uint32_t polygon) {
  const glm::dvec3* corner = &scene.vertices[scene.first[polygon]];
  return glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
}

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::min(1.0, glm::dot(a, b)));
}

TEST(Smooth, ASphereIsRound) {
  const Scene scene = sphere();
  const SmoothNormals smooth(scene);
  double flat = 0, gentle = 0;
  for (std::uint32_t polygon = 0; polygon < scene.polygon_count(); ++polygon) {
    const glm::dvec3* corner = &scene.vertices[scene.first[polygon]];
    for (const glm::dvec3& share : {glm::dvec3(1, 0, 0), glm::dvec3(0.5, 0.5, 0),
                                    glm::dvec3(0.6, 0.3, 0.1), glm::dvec3(0.2, 0.2, 0.6)}) {
      const glm::dvec3 at = share.x * corner[0] + share.y * corner[1] + share.z * corner[2];
      const glm::dvec3 radial = glm::normalize(at - kMiddle), found = smooth.at(polygon, at);
      EXPECT_NEAR(glm::length(found), 1, 1e-9);
      flat += angle(flat_normal(scene, polygon), radial);
      gentle += angle(found, radial);
      EXPECT_LT(angle(found, radial), 0.05);
    }
  }
  EXPECT_LT(gentle, 0.1 * flat);
}

// Armour stands out over a facet's border: what is hit there is shaded as the border is.
TEST(Smooth, BeyondASide) {
  Scene scene;
  scene.materials.resize(1);
  add_sphere(scene, kMiddle, 10, 8, 0);
  const SmoothNormals smooth(scene);
  for (std::uint32_t polygon = 0; polygon < scene.polygon_count(); ++polygon) {
    const glm::dvec3* corner = &scene.vertices[scene.first[polygon]];
    const glm::dvec3 side = 0.5 * (corner[0] + corner[1]), out = side - corner[2];
    EXPECT_LT(glm::distance(smooth.at(polygon, side + 0.3 * out), smooth.at(polygon, side)), 0.2);
    EXPECT_LT(glm::distance(smooth.at(polygon, corner[0] + 0.5 * (corner[0] - corner[1])),
                            smooth.at(polygon, corner[0])),
              1e-6);
  }
}

// What two polygons say of the side between them is the same.
TEST(Smooth, NoSeams) {
  const Scene scene = sphere();
  const SmoothNormals smooth(scene);
  int shared = 0;
  for (std::uint32_t a = 0; a < 40; ++a) {
    for (std::uint32_t b = a + 1; b < scene.polygon_count(); ++b) {
      std::vector<glm::dvec3> common;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (scene.vertices[scene.first[a] + i] == scene.vertices[scene.first[b] + j])
            common.push_back(scene.vertices[scene.first[a] + i]);
      if (common.size() != 2) continue;
      ++shared;
      const glm::dvec3 at = 0.3 * common[0] + 0.7 * common[1];
      EXPECT_LT(glm::distance(smooth.at(a, at), smooth.at(b, at)), 1e-6);
    }
  }
  EXPECT_GT(shared, 20);
}

TEST(Smooth, ABoxStaysSharp) {
  Scene scene;
  scene.materials.resize(1);
  add_box(scene, {kMiddle, {4, 5, 6}}, 0);
  const SmoothNormals smooth(scene);
  for (std::uint32_t polygon = 0; polygon < scene.polygon_count(); ++polygon) {
    const glm::dvec3* corner = &scene.vertices[scene.first[polygon]];
    for (const glm::dvec3& at :
         {corner[0], 0.5 * (corner[0] + corner[2]), corner[0] + 0.2 * (corner[0] - corner[2])})
      EXPECT_LT(glm::distance(smooth.at(polygon, at), flat_normal(scene, polygon)), 1e-9);
  }
}

// Linear between the corners of a triangle, as Gouraud and Phong have it.
TEST(Smooth, InterpolatesALine) {
  Scene roof;  // two quads that meet at 30 degrees
  roof.materials.resize(1);
  roof.add({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, 0);
  roof.add({{10, 0, 0}, {18.66, 0, -5}, {18.66, 10, -5}, {10, 10, 0}}, 0);
  const SmoothNormals smooth(roof);
  const glm::dvec3 up(0, 0, 1), slope = glm::normalize(glm::dvec3(5, 0, 8.66));
  const glm::dvec3 ridge = glm::normalize(up + slope);
  EXPECT_LT(glm::distance(smooth.at(0, {0, 4, 0}), up), 1e-6);
  EXPECT_LT(glm::distance(smooth.at(0, {10, 4, 0}), ridge), 1e-6);
  EXPECT_LT(glm::distance(smooth.at(1, {10, 4, 0}), ridge), 1e-6);
  EXPECT_LT(glm::distance(smooth.at(0, {5, 5, 0}), glm::normalize(up + ridge)), 1e-6);
}

// A file knows better; but not where it says that a corner faces away.
TEST(Smooth, TakesTheNormalsOfTheScene) {
  const glm::dvec3 tilted = glm::normalize(glm::dvec3(1, 2, 3)), behind(0, 0.6, -0.8);
  Scene roof;
  roof.materials.resize(1);
  roof.add({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, 0, {tilted, tilted, behind, {}});
  const SmoothNormals smooth(roof);
  const glm::dvec3 up(0, 0, 1);
  EXPECT_LT(glm::distance(smooth.at(0, {4, 0, 0}), tilted), 1e-6);
  EXPECT_LT(glm::distance(smooth.at(0, {4, 10, 0}), up), 1e-6);
}

}  // namespace
}  // namespace rc2::scene
