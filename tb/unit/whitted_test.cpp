// The continuous ray tracer in scenes whose answers are known.
#include "sw/truth/whitted.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sw/scene/shade.h"
#include "sw/scene/shapes.h"

namespace rc2::truth {
namespace {

using rays::Body;
using scene::Material;
using scene::Scene;

constexpr int kSide = 32;

Material glowing(const glm::vec3& colour) {
  Material material;
  material.diffuse = glm::vec3(0);
  material.emission = colour;
  return material;
}

void expect_near(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-4F) << a.x << " " << a.y << " " << a.z;
}

std::vector<Body> all(const Scene& scene, Body body) {
  std::vector<Body> bodies(scene.polygon_count(), body);
  return bodies;
}

TEST(Whitted, AddsWhatAMirrorShows) {
  Scene scene;
  scene.materials = {glowing({0.2F, 0, 0}), glowing({0, 0.5F, 0})};
  scene.materials[0].mirror = 0.5F;
  scene::add_box(scene, {{16, 16, 4}, {8, 8, 2}}, 0);
  scene::add_box(scene, {{16, 16, 28}, {8, 8, 2}}, 1);
  const Whitted truth(scene, all(scene, Body::solid), kSide);
  const glm::dvec3 from(13, 16, 20), way = glm::normalize(glm::dvec3(0.1, 0, -1));
  expect_near(truth.colour(from, way, {}, 0), {0.2F, 0, 0});
  expect_near(truth.colour(from, way, {}, 1), {0.2F, 0.25F, 0});
  const auto hit = truth.first_hit(from, way, false);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->at.z, 6, 1e-9);
  EXPECT_NEAR(hit->at.x, 14.4, 1e-9);
  EXPECT_NEAR(hit->normal.z, 1, 1e-9);
}

TEST(Whitted, BendsTwiceInGlassAndGoesOn) {
  Scene scene;
  scene.materials = {glowing({9, 9, 9})};
  scene.materials[0].transparency = 1;
  scene.materials[0].refractive_index = 1.5F;
  scene::add_box(scene, {{16, 16, 16}, {12, 12, 4}}, 0);
  const Whitted truth(scene, all(scene, Body::solid), kSide);
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.6, 0, -0.8));
  expect_near(truth.colour({8, 16, 28}, way, {}, 2), glm::vec3(9) + scene::kBackground);
  const auto into = refract(way, {0, 0, 1}, 1 / 1.5);
  ASSERT_TRUE(into);
  EXPECT_NEAR(into->x, 0.4, 1e-12);
  const auto back = refract(*into, {0, 0, 1}, 1.5);
  ASSERT_TRUE(back);
  EXPECT_NEAR(glm::distance(*back, way), 0, 1e-12);
  EXPECT_FALSE(refract(way, {0, 0, 1}, 1.7)) << "beyond the angle of total reflection";
}

TEST(Whitted, SeesARoomFromWithinAndASheetFromBothSides) {
  Scene scene;
  scene.materials = {glowing({1, 0, 0})};
  scene.add({{8, 8, 16}, {24, 8, 16}, {24, 24, 16}, {8, 24, 16}}, 0);
  for (const Body body : {Body::solid, Body::room, Body::sheet}) {
    const Whitted truth(scene, all(scene, body), kSide);
    EXPECT_TRUE(truth.first_hit({16, 16, 30}, {0, 0, -1}, false));
    EXPECT_EQ(truth.first_hit({16, 16, 2}, {0, 0, 1}, false).has_value(), body == Body::sheet);
  }
}

TEST(Whitted, CastsShadows) {
  Scene scene;
  scene.materials = {Material{}};
  scene::add_box(scene, {{16, 16, 4}, {12, 12, 2}}, 0);
  scene::add_box(scene, {{16, 16, 16}, {2, 2, 2}}, 0);
  const Whitted truth(scene, all(scene, Body::solid), kSide);
  const Lamp lamp{{16, 16, 28}, glm::vec3(1)};
  const glm::vec3 dark = scene::own_light(Material{});
  const glm::dvec3 slant = glm::normalize(glm::dvec3(-1, 0, -1));
  expect_near(truth.colour({22, 16, 11}, slant, {lamp}, 0), dark);
  EXPECT_GT(truth.colour({30, 16, 11}, slant, {lamp}, 0).x, dark.x + 0.1F);
  Lamp through = lamp;
  through.casts_shadows = false;
  EXPECT_GT(truth.colour({22, 16, 11}, slant, {through}, 0).x, dark.x + 0.1F);
}

}  // namespace
}  // namespace rc2::truth
