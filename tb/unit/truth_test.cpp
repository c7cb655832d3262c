#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "sw/scene/random.h"
#include "sw/scene/shapes.h"
#include "sw/truth/verdict.h"

namespace rc2::truth {
namespace {

using scene::Random;
using scene::Scene;

constexpr int kSide = 32;
const glm::dvec3 kMiddle(15.3, 16.1, 15.7);

Scene empty_scene() {
  Scene scene;
  scene.materials.resize(1);
  return scene;
}

Scene sphere(double radius) {
  Scene scene = empty_scene();
  scene::add_sphere(scene, kMiddle, radius, 0.4, 0);
  return scene;
}

glm::dvec3 random_point(Random& random, double low, double high) {
  return glm::dvec3{random.between(low, high), random.between(low, high),
                    random.between(low, high)};
}

// Distance of the middle of the sphere from the segment.
double nearest_approach(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 way = to - from;
  const double t = glm::clamp(glm::dot(kMiddle - from, way) / glm::dot(way, way), 0.0, 1.0);
  return glm::distance(from + t * way, kMiddle);
}

TEST(Truth, ASphereIsInTheWayOfSegmentsThatComeNear) {
  const double radius = 9;
  const Surface surface(sphere(radius));
  Random random(1);
  int free = 0, blocked = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 from = random_point(random, 0, 31), to = random_point(random, 0, 31);
    if (glm::distance(from, kMiddle) < radius || glm::distance(to, kMiddle) < radius) continue;
    const double distance = nearest_approach(from, to);
    if (std::abs(distance - radius) < 0.01) continue;  // the mesh is no exact sphere
    ASSERT_EQ(surface.sees(from, to), distance > radius);
    (distance > radius ? free : blocked) += 1;
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(blocked, 1000);
}

// Of rays in any direction none, of those aimed at sides and corners hardly any.
TEST(Truth, RaysDoNotSlipThroughAClosedMesh) {
  const Surface surface(sphere(9));
  Random random(2);
  const Triangles& triangles = surface.triangles();
  const int rays = 20000;
  int slipped = 0;
  for (int i = 0; i < rays; ++i) {
    EXPECT_FALSE(surface.sees_infinity(kMiddle, random_point(random, -1, 1)));
    const auto triangle = static_cast<std::size_t>(random.below(1280));
    const glm::uvec3& corner = triangles.corners[triangle];
    const glm::dvec3 from = triangles.vertices[corner.x], to = triangles.vertices[corner.y];
    const glm::dvec3 aim = from + 0.5 * random.below(3) * (to - from);
    slipped += surface.sees(kMiddle, kMiddle + 1.5 * (aim - kMiddle));
  }
  EXPECT_LT(slipped, rays / 1000);
}

TEST(Truth, WindingCountsTheSolidsRoundAPoint) {
  Scene scene = empty_scene();
  scene::add_box(scene, {glm::dvec3(15), glm::dvec3(14)}, 0, true);  // a room
  scene::add_box(scene, {glm::dvec3(15), glm::dvec3(8)}, 0);         // a solid in it
  scene::add_box(scene, {glm::dvec3(15), glm::dvec3(6)}, 0, true);   // with a cavity
  scene::add_box(scene, {{20, 15, 15}, glm::dvec3(4, 3, 3)}, 0);     // another through its wall
  const Surface surface(scene);
  EXPECT_EQ(surface.winding(glm::dvec3(-5)), 0);
  EXPECT_EQ(surface.winding(glm::dvec3(3)), -1);
  EXPECT_EQ(surface.winding({8, 15, 15}), 0);
  EXPECT_EQ(surface.winding({12, 15, 15}), -1);
  EXPECT_EQ(surface.winding({22, 15, 15}), 1);
  EXPECT_EQ(surface.winding({23.5, 15, 15}), 0);
}

TEST(Truth, TheNearestPointOfABoxIsTheClampedPoint) {
  Scene scene = empty_scene();
  const glm::dvec3 low(8, 9, 10), high(20, 18, 25);
  scene::add_box(scene, {0.5 * (low + high), 0.5 * (high - low)}, 0);
  const Surface surface(scene);
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 point = random_point(random, 0, 31);
    const glm::dvec3 clamped = glm::clamp(point, low, high);
    if (clamped == point) continue;
    EXPECT_LT(glm::distance(surface.nearest(point).at, clamped), 1e-4);
  }
}

TEST(Truth, AConcavePolygonIsCutIntoItsArea) {
  Scene scene = empty_scene();
  scene.add({{0, 0, 1},
             {6.5, 0, 1},
             {6.5, 6, 1},
             {4, 6, 1},
             {4, 2.25, 1},
             {2, 2.25, 1},
             {2, 6, 1},
             {0, 6, 1}},
            0);
  const Triangles triangles = triangles_of(scene);
  glm::dvec3 area(0);
  for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
    EXPECT_GT(triangles.doubled_area(i).z, 0);
    area += 0.5 * triangles.doubled_area(i);
  }
  EXPECT_NEAR(area.z, 6.5 * 2.25 + 2 * 3.75 + 2.5 * 3.75, 1e-9);
}

TEST(Truth, SamplesAreSpreadByAreaAndLieInTheirVoxels) {
  const double radius = 9, density = 40;
  const Surface surface(sphere(radius));
  const Samples samples(surface, kSide, density);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(static_cast<double>(samples.count()), density * 4 * pi * radius * radius,
              0.01 * static_cast<double>(samples.count()));
  std::size_t found = 0;
  std::int64_t upper = 0;
  for (glm::ivec3 at{0}; at.z < kSide; ++at.z)
    for (at.y = 0; at.y < kSide; ++at.y)
      for (at.x = 0; at.x < kSide; ++at.x)
        for (const Sample& sample : samples.of(at)) {
          ++found;
          EXPECT_EQ(sample.winding, 0);
          const glm::dvec3 out = glm::dvec3(sample.at) - kMiddle;
          EXPECT_NEAR(glm::length(out), radius + kLift, 0.01);
          const glm::dvec3 off = glm::abs(glm::dvec3(sample.at) - glm::dvec3(at));
          EXPECT_LT(std::max({off.x, off.y, off.z}), 0.5 + 2 * kLift);
          upper += out.z > 0.5 * radius;  // Archimedes: a quarter of the sphere
          EXPECT_EQ(sample.seen, surface.triangles().doubled_area(sample.triangle).z > 0);
        }
  EXPECT_EQ(found, samples.count());
  EXPECT_NEAR(static_cast<double>(upper), 0.25 * static_cast<double>(found),
              0.01 * static_cast<double>(found));
}

std::vector<glm::ivec3> voxels_with_samples(const Samples& samples) {
  std::vector<glm::ivec3> voxels;
  for (glm::ivec3 at{0}; at.z < kSide; ++at.z)
    for (at.y = 0; at.y < kSide; ++at.y)
      for (at.x = 0; at.x < kSide; ++at.x)
        if (samples.of(at).first != samples.of(at).last) voxels.push_back(at);
  return voxels;
}

// A convex body shadows nothing of itself that faces the light: beyond the plane of the polar of
// the light all is dark.
TEST(Truth, ASphereIsLitUpToThePolarOfTheLight) {
  const double radius = 9;
  const Surface surface(sphere(radius));
  const Samples samples(surface, kSide, 40);
  const std::vector<glm::ivec3> voxels = voxels_with_samples(samples);
  for (const glm::dvec3 light : {glm::dvec3(30, 29, 28), glm::dvec3(1, 15, 2)}) {
    const std::vector<Verdict> verdicts = judge(surface, samples, voxels, light);
    const glm::dvec3 way = light - kMiddle;
    const double height = radius * radius / glm::length(way);
    int lit = 0;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      EXPECT_TRUE(verdicts[i].exposed);
      const double above = glm::dot(glm::dvec3(voxels[i]) - kMiddle, glm::normalize(way)) - height;
      if (std::abs(above) < 1) continue;
      EXPECT_EQ(verdicts[i].lit, above > 0);
      EXPECT_EQ(verdicts[i].faces_light, above > 0);
      EXPECT_EQ(verdicts[i].facing_are_lit, above > 0);
      lit += above > 0;
    }
    EXPECT_GT(lit, 100);
  }
}

TEST(Truth, WhatIsInsideAnotherSolidDoesNotCount) {
  Scene scene = empty_scene();
  scene::add_box(scene, {{8, 8, 8}, glm::dvec3(4)}, 0);
  scene::add_box(scene, {{12, 8, 8}, glm::dvec3(3, 2, 2)}, 0);
  const Surface surface(scene);
  const Samples samples(surface, kSide, 40);
  const auto verdict = [&](glm::ivec3 voxel) {
    return judge(surface, samples, {voxel}, {30, 9, 30}).front();
  };
  EXPECT_FALSE(verdict({9, 8, 8}).exposed);  // the left side of the second box
  EXPECT_TRUE(verdict({15, 8, 8}).lit);      // its right side
  EXPECT_TRUE(verdict({4, 8, 8}).exposed);
  EXPECT_FALSE(verdict({4, 8, 8}).lit);
}

TEST(Truth, AShadowEndsWhereThePyramidDoes) {
  Scene scene = empty_scene();
  scene::add_box(scene, {{16, 16, 1}, {15, 15, 1}}, 0);   // the floor, its top at z = 2
  scene::add_box(scene, {{16, 16, 12}, {3, 2, 0.5}}, 0);  // a plate above it
  const Surface surface(scene);
  const Samples samples(surface, kSide, 64);
  const glm::dvec3 light(14, 17, 22);
  const std::vector<glm::ivec3> voxels = voxels_with_samples(samples);
  const std::vector<Verdict> verdicts = judge(surface, samples, voxels, light);
  int dark = 0;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const glm::ivec3 at = voxels[i];
    if (at.z != 2 || glm::max(at.x, at.y) > 29 || glm::min(at.x, at.y) < 3) continue;
    // Central projection of the plate's upper side, which is the larger shadow.
    const double scale = (22 - 2) / (22 - 12.5);
    const glm::dvec3 way = (glm::dvec3(at) - light) / scale + light;
    const double x = std::abs(way.x - 16) - 3, y = std::abs(way.y - 16) - 2;
    if (std::abs(x) < 0.3 || std::abs(y) < 0.3) continue;
    EXPECT_EQ(verdicts[i].lit, x > 0 || y > 0) << at.x << ' ' << at.y;
    dark += x < 0 && y < 0;
  }
  EXPECT_GT(dark, 40);
}

}  // namespace
}  // namespace rc2::truth
