// What the machine is compared with does what it says.
#include <gtest/gtest.h>

#include <boost/rational.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sw/lines/amanatides_woo.h"
#include "sw/peers/grid_walk.h"
#include "sw/peers/layer_sweep.h"
#include "sw/peers/mesh_volume.h"
#include "sw/peers/shadow_rays.h"
#include "sw/scene/random.h"
#include "sw/scene/shapes.h"
#include "sw/truth/surface.h"

namespace rc2::peers {
namespace {

using Rational = boost::rational<int>;

constexpr int kSide = 13;

scene::Scene sphere(double radius) {
  scene::Scene scene;
  scene.materials.resize(1);
  scene::add_sphere(scene, glm::dvec3(15.5), radius, 0, 0, 5);
  return scene;
}

glm::ivec3 random_voxel(scene::Random& random) {
  const auto at = [&] { return static_cast<int>(random.between(0, kSide)); };
  const int x = at(), y = at();
  return {x, y, at()};
}

BitGrid random_grid(scene::Random& random, int voxels, const glm::ivec3& light) {
  BitGrid grid(kSide);
  for (int i = 0; i < voxels; ++i) {
    const glm::ivec3 at = random_voxel(random);
    if (at != light) grid.set(at);
  }
  return grid;
}

template <class Visit>
void for_each_voxel(Visit visit) {
  for (glm::ivec3 at{0}; at.z < kSide; ++at.z)
    for (at.y = 0; at.y < kSide; ++at.y)
      for (at.x = 0; at.x < kSide; ++at.x) visit(at);
}

TEST(ShadowRays, OneAndEightSayWhatTheTruthSays) {
  const scene::Scene scene = sphere(9);
  const truth::Surface surface(scene);
  const ShadowRays rays(surface.triangles());
  scene::Random random(1);
  std::vector<glm::vec3> places;
  for (int i = 0; i < 1003; ++i) {  // no multiple of eight
    const double x = random.between(0, 31), y = random.between(0, 31);
    places.emplace_back(x, y, random.between(0, 31));
  }
  const glm::vec3 light(1, 2, 30);
  const std::vector<bool> one = rays.one_by_one(places, light),
                          eight = rays.by_eight(places, light);
  ASSERT_EQ(one.size(), places.size());
  ASSERT_EQ(eight.size(), places.size());
  int lit = 0, wrong = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    wrong += one[i] != surface.sees(places[i], light) || eight[i] != one[i] ? 1 : 0;
    lit += one[i] ? 1 : 0;
  }
  EXPECT_LE(wrong, 2);  // rays along a side of a triangle
  EXPECT_GT(lit, 200);
  EXPECT_LT(lit, 900);
}

TEST(GridWalk, IsStoppedByWhatItsLineMeets) {
  scene::Random random(2);
  int lit = 0, dark = 0;
  for (int round = 0; round < 50; ++round) {
    const glm::ivec3 light = random_voxel(random);
    const BitGrid stops = random_grid(random, 60, light);
    std::vector<glm::ivec3> voxels;
    for_each_voxel([&](const glm::ivec3& at) { voxels.push_back(at); });
    for (const int leave : {0, 2}) {
      const std::vector<bool> found = walk_to_light(stops, voxels, light, leave);
      for (std::size_t i = 0; i < voxels.size(); ++i) {
        std::vector<glm::ivec3> way;
        lines::amanatides_woo(voxels[i], light, [&](const glm::ivec3& at) { way.push_back(at); });
        bool is_free = true;
        for (std::size_t k = static_cast<std::size_t>(leave) + 1; k + 1 < way.size(); ++k)
          is_free = is_free && !stops.at(way[k]);
        ASSERT_EQ(found[i], is_free);
        (is_free ? lit : dark) += 1;
      }
    }
  }
  EXPECT_GT(lit, 10000);
  EXPECT_GT(dark, 10000);
}

// From a voxel back to the light, each step by the rounded fraction.
bool reached(const BitGrid& stops, const glm::ivec3& light, glm::ivec3 at) {
  for (glm::ivec3 way = at - light;;) {
    const glm::ivec3 size = glm::abs(way);
    const int k = std::max({size.x, size.y, size.z});
    if (k <= 1) return true;
    for (int axis = 0; axis < 3; ++axis) {
      // The nearest integer to |u| (k - 1) / k, ties up.
      const Rational exact = Rational(size[axis] * (k - 1), k) + Rational(1, 2);
      const int nearest = exact.numerator() / exact.denominator();
      way[axis] = way[axis] < 0 ? -nearest : nearest;
    }
    if (stops.at(light + way)) return false;
  }
}

TEST(LayerSweep, ReachesWhatIsFreeBackToTheLight) {
  scene::Random random(3);
  int lit = 0, dark = 0;
  for (int round = 0; round < 50; ++round) {
    const glm::ivec3 light = random_voxel(random);
    const BitGrid stops = random_grid(random, 60, light);
    const BitGrid found = sweep_layers(stops, light);
    for_each_voxel([&](const glm::ivec3& at) {
      const bool is_lit = reached(stops, light, at);
      EXPECT_EQ(found.at(at), is_lit) << at.x << ' ' << at.y << ' ' << at.z;
      (is_lit ? lit : dark) += 1;
    });
  }
  EXPECT_GT(lit, 10000);
  EXPECT_GT(dark, 10000);
}

TEST(MeshVolume, HasTheVoxelsNearTheMesh) {
  const int n = 32;
  const double radius = 10.2;
  const truth::Surface surface(sphere(radius));
  for (const double distance : {0.5, 0.867}) {
    int doubtful = 0;
    const std::vector<glm::ivec3> voxels = mesh_to_voxels(surface.triangles(), n, distance);
    std::size_t found = 0;
    for (glm::ivec3 at{0}; at.z < n; ++at.z)
      for (at.y = 0; at.y < n; ++at.y)
        for (at.x = 0; at.x < n; ++at.x) {
          const bool has = found < voxels.size() && voxels[found] == at;
          found += has ? 1 : 0;
          const double off = glm::distance(surface.nearest(at).at, glm::dvec3(at)) - distance;
          if (std::abs(off) < 1e-3) {
            ++doubtful;
          } else {
            EXPECT_EQ(has, off < 0) << at.x << ' ' << at.y << ' ' << at.z;
          }
        }
    EXPECT_EQ(found, voxels.size());  // in order
    EXPECT_GT(found, 1000U);
    EXPECT_LT(doubtful, 20);
  }
}

}  // namespace
}  // namespace rc2::peers
