// The yardstick must do the work it is timed for: the voxels of the golden machine.
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <map>
#include <tuple>

#include "sw/direct/voxeliser.h"
#include "sw/facet/facet.h"
#include "sw/golden/golden_machine.h"
#include "sw/scene/random.h"

namespace rc2::direct {
namespace {

using scene::Random;
using scene::Scene;

VoxelMemory golden_voxels(const Scene& scene, int n, int fraction_bits) {
  MachineConfig config;
  config.n = n;
  config.fraction_bits = fraction_bits;
  golden::GoldenMachine machine(config);
  machine.load(facet::build_facets(scene, n, fraction_bits, facet::Rule::armoured).packets, {});
  return machine.read_voxels();
}

Scene one_polygon(const Scene& scene, std::size_t polygon) {
  Scene one;
  one.add({scene.vertices.begin() + scene.first[polygon],
           scene.vertices.begin() + scene.first[polygon + 1]},
          0);
  return one;
}

// Of every voxel the first polygon of which, alone, the golden machine makes it.
using Owners = std::map<std::tuple<int, int, int>, std::uint32_t>;
Owners golden_owners(const Scene& scene, int n, int fraction_bits) {
  Owners owners;
  for (std::uint32_t i = 0; i < scene.polygon_count(); ++i)
    for (const VoxelRecord& voxel : golden_voxels(one_polygon(scene, i), n, fraction_bits))
      owners.try_emplace({voxel.at.z, voxel.at.y, voxel.at.x}, i);
  return owners;
}

Owners direct_owners(const Scene& scene, int n, int fraction_bits) {
  Voxeliser voxeliser(n, fraction_bits);
  voxeliser.fill(scene);
  Owners owners;
  for (glm::ivec3 at{0}; at.z < n; ++at.z)
    for (at.y = 0; at.y < n; ++at.y)
      for (at.x = 0; at.x < n; ++at.x)
        if (voxeliser.owner(at) != Voxeliser::kFree)
          owners[{at.z, at.y, at.x}] = voxeliser.owner(at);
  EXPECT_EQ(static_cast<std::int64_t>(owners.size()), voxeliser.voxel_count());
  return owners;
}

glm::dvec3 random_point(Random& random, double low, double high) {
  return glm::dvec3{random.between(low, high), random.between(low, high),
                    random.between(low, high)};
}

// Corners anywhere in the cube, or near each other; some in a plane of the grid or half-way between
// two of them, some in a line.
void add_triangle(Scene& scene, Random& random, int n, int fraction_bits) {
  const double low = fraction_bits == 0 ? 0 : -0.5, high = n - 1 - low;
  std::vector<glm::dvec3> corners(3);
  const glm::dvec3 middle = random_point(random, low, high);
  const double reach = random.below(2) == 0 ? n : random.between(0, 3);
  for (glm::dvec3& corner : corners)
    corner = glm::clamp(middle + random_point(random, -reach, reach), low, high);
  const int axis = random.below(3);
  switch (random.below(5)) {
    case 0:
      for (glm::dvec3& corner : corners) corner[axis] = 0.5 * random.below(2 * n - 1);
      break;
    case 1:
      for (glm::dvec3& corner : corners) corner[axis] = corners[0][axis];
      break;
    case 2:
      corners[2] = corners[0] + (corners[1] - corners[0]) * random.unit();
      break;
    default:
      break;
  }
  scene.add(corners, 0);
}

TEST(Direct, MakesTheVoxelsOfTheGoldenMachine) {
  Random random(1);
  std::size_t filled = 0;
  for (int round = 0; round < 1000; ++round) {
    const int n = 2 + random.below(20), fraction_bits = random.below(9);
    Scene scene;
    for (int i = 0; i < 12; ++i) add_triangle(scene, random, n, fraction_bits);
    const Owners expected = golden_owners(scene, n, fraction_bits);
    ASSERT_EQ(direct_owners(scene, n, fraction_bits), expected)
        << "round " << round << ", n " << n << ", f " << fraction_bits;
    filled += expected.size();
  }
  EXPECT_GT(filled, 100'000U);
}

TEST(Direct, MakesLargeTrianglesToo) {
  Random random(2);
  for (const int n : {64, 100}) {
    Scene scene;
    for (int i = 0; i < 4; ++i)
      scene.add({random_point(random, 0, n - 1), random_point(random, 0, n - 1),
                 random_point(random, 0, n - 1)},
                0);
    EXPECT_EQ(direct_owners(scene, n, 4), golden_owners(scene, n, 4));
  }
}

TEST(Direct, SkipsWhatIsNoTriangleInTheCube) {
  Scene scene;
  scene.add({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, 0);
  scene.add({{0, 0, 0}, {4, 0, 0}, {4, 8, 0}}, 0);
  scene.add({{-1, 0, 0}, {4, 0, 0}, {4, 4, 0}}, 0);
  scene.add({{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, 0);
  Voxeliser voxeliser(8, 4);
  voxeliser.fill(scene);
  EXPECT_EQ(voxeliser.voxel_count(), 0);
}

}  // namespace
}  // namespace rc2::direct
