// What is inside a mesh, what passes its voxels, and the thesis's first two discretisers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <set>
#include <tuple>

#include "sw/base/error.h"
#include "sw/facet/facet.h"
#include "sw/scene/random.h"
#include "sw/scene/shapes.h"
#include "sw/surface/bilinear.h"
#include "sw/surface/closed_meshes.h"
#include "sw/surface/leaks.h"
#include "sw/surface/mesh.h"
#include "sw/surface/slices.h"
#include "sw/surface/winding.h"

namespace rc2::surface {
namespace {

using facet::Border;
using facet::Vertex;
using scene::Random;
using scene::Scene;

// Debian's assimp-testmodels. One shell each, but CrazyEngine.lxo: many, some inside out, that
// overlap.
const std::filesystem::path kModels = "/usr/share/assimp/models";
const char* const kClosedModels[] = {"Collada/duck.dae", "BLEND/HUMAN.blend",
                                     "BLEND/TorusLightsCams_250_compressed.blend",
                                     "LWO/LXOB_Modo/CrazyEngine.lxo"};
constexpr int kModelSide = 64;

Scene closed_model(const std::string& name) {
  Scene scene = scene::read_file((kModels / name).string());
  scene::fit_to_cube(scene, kModelSide);
  return scene;
}

Scene box(const glm::dvec3& low, const glm::dvec3& high, bool inwards = false) {
  Scene scene;
  scene.materials.resize(1);
  scene::add_box(scene, {0.5 * (low + high), 0.5 * (high - low)}, 0, inwards);
  return scene;
}

void append(Scene& scene, const Scene& other) {
  for (std::size_t i = 0; i < other.polygon_count(); ++i)
    scene.add({&other.vertices[other.first[i]], &other.vertices[other.first[i + 1]]}, 0);
}

// Sign of a value at p + (e, e^2, e^3), e -> 0+, where it has the gradient given.
int sign(std::int64_t value, const Vertex& gradient) {
  if (value != 0) return value > 0 ? 1 : -1;
  for (int axis = 0; axis < 3; ++axis)
    if (gradient[axis] != 0) return gradient[axis] > 0 ? 1 : -1;
  return 0;
}

// The winding number from the triangles that a ray towards +x crosses, one after another.
int winding_along_x(const Mesh& mesh, const glm::ivec3& voxel) {
  const Vertex p = Vertex(voxel) * (std::int64_t{1} << mesh.fraction_bits);
  int winding = 0;
  for (const Border& border : mesh.facets) {
    for (std::size_t i = 2; i < border.size(); ++i) {
      const Vertex &a = border[0], &b = border[i - 1], &c = border[i];
      const Vertex normal = facet::cross(b - a, c - a);
      const int facing = sign(normal.x, Vertex(0));
      const auto side = [&](const Vertex& from, const Vertex& to) {
        const Vertex along = to - from, at = p - from;
        return sign(along.y * at.z - along.z * at.y, {0, -along.z, along.y});
      };
      if (facing == 0 || side(a, b) != facing || side(b, c) != facing || side(c, a) != facing)
        continue;
      // The ray crosses if the voxel is behind a triangle that faces +x, or before one that does
      // not.
      if (sign(facet::dot(normal, p - a), normal) == -facing) winding += facing;
    }
  }
  return winding;
}

void expect_winding(const Scene& scene, int n, int fraction_bits) {
  const Mesh mesh = quantise(scene, fraction_bits);
  ASSERT_TRUE(mesh.closed) << scene.name;
  const auto winding = winding_numbers(mesh, n);
  Random random(1);
  const auto samples = static_cast<int>(4'000'000 / (mesh.facets.size() + 1000));
  for (int i = 0; i < samples; ++i) {
    const int x = random.below(n), y = random.below(n), z = random.below(n);
    ASSERT_EQ((winding[{x, y, z}]), winding_along_x(mesh, {x, y, z}))
        << scene.name << " f = " << fraction_bits << " at " << x << "," << y << "," << z;
  }
}

// Few fraction bits put many vertices, edges and faces on voxel centres.
TEST(Winding, EqualsACountAlongAnotherAxis) {
  for (const MeshFamily& family : kMeshFamilies)
    for (const int f : {0, 1, 4, 8}) expect_winding(make_mesh(family, 7), family.n, f);
  for (const char* name : kClosedModels) expect_winding(closed_model(name), kModelSide, 4);
}

TEST(Winding, CountsTheVoxelsOfBoxes) {
  // Voxel centres are shifted upwards: those on the lower faces are inside.
  for (const auto& [low, high] : {std::pair(2.0, 6.0), std::pair(2.5, 6.5), std::pair(2.0, 6.5),
                                  std::pair(2.5, 6.0), std::pair(2.125, 2.875)}) {
    const auto winding = winding_numbers(quantise(box(glm::dvec3(low), glm::dvec3(high)), 4), 9);
    const double side = std::ceil(high) - std::ceil(low);
    EXPECT_EQ(std::count(winding.begin(), winding.end(), 1), side * side * side) << low;
    EXPECT_EQ(std::count(winding.begin(), winding.end(), 0), 729 - side * side * side) << low;
  }
}

TEST(Winding, OfMeshesIsTheirVolume) {
  for (const MeshFamily& family : kMeshFamilies) {
    double volume = 0, inside = 0;
    for (int seed = 1; seed <= 8; ++seed) {
      const Scene scene = make_mesh(family, seed);
      const Mesh mesh = quantise(scene, 8);
      for (const Border& border : mesh.facets)
        for (std::size_t i = 2; i < border.size(); ++i)
          volume +=
              static_cast<double>(facet::dot(border[0], facet::cross(border[i - 1], border[i]))) /
              (6.0 * (1 << 24));
      for (const int number : winding_numbers(mesh, family.n)) {
        ASSERT_TRUE(number == 0 || number == 1) << scene.name;
        inside += number;
      }
    }
    EXPECT_NEAR(inside / volume, 1.0, 0.05) << family.name;
  }
}

TEST(Winding, AddsUpWhereShellsOverlap) {
  Scene scene = box(glm::dvec3(1), glm::dvec3(9));
  append(scene, box(glm::dvec3(2), glm::dvec3(5), true));    // a hole
  append(scene, box(glm::dvec3(6), glm::dvec3(8)));          // counted twice
  append(scene, box(glm::dvec3(10), glm::dvec3(11), true));  // inside out
  const auto winding = winding_numbers(quantise(scene, 4), 12);
  EXPECT_EQ((winding[{0, 0, 0}]), 0);
  EXPECT_EQ((winding[{1, 1, 1}]), 1);
  EXPECT_EQ((winding[{3, 3, 3}]), 0);
  EXPECT_EQ((winding[{7, 7, 7}]), 2);
  EXPECT_EQ((winding[{10, 10, 10}]), -1);
}

// Facets partly or wholly outside the cube still count for the voxels in it.
TEST(Winding, ReachesBeyondTheCube) {
  const Mesh mesh = quantise(box(glm::dvec3(-3), glm::dvec3(20)), 4);
  for (const int number : winding_numbers(mesh, 8)) ASSERT_EQ(number, 1);
}

TEST(Mesh, IsClosedOnlyIfEverySideIsUsedBothWays) {
  for (const MeshFamily& family : kMeshFamilies) {
    Scene scene = make_mesh(family, 3);
    ASSERT_TRUE(quantise(scene, 4).closed) << family.name;
    std::swap(scene.vertices[0], scene.vertices[1]);  // the first polygon's: turned over or twisted
    EXPECT_FALSE(quantise(scene, 4).closed) << family.name;
    std::swap(scene.vertices[0], scene.vertices[1]);
    scene.add({scene.vertices[0], scene.vertices[1], scene.vertices[2]}, 0);
    EXPECT_FALSE(quantise(scene, 4).closed) << family.name;
  }
}

TEST(Mesh, WeldsWhatRoundingBringsTogether) {
  Scene scene = make_mesh(kMeshFamilies.front(), 1);
  scene.vertices[0].x += 1.0 / 512;
  EXPECT_TRUE(quantise(scene, 0).closed);
  EXPECT_FALSE(quantise(scene, 9).closed);
}

TEST(Mesh, HasTheFacetsOfTheMachine) {
  std::vector<std::pair<Scene, int>> scenes;
  scenes.reserve(std::size(kMeshFamilies));
  for (const MeshFamily& family : kMeshFamilies)
    scenes.emplace_back(make_mesh(family, 5), family.n);
  for (const char* name : kClosedModels) scenes.emplace_back(closed_model(name), kModelSide);
  // Crooked polygons on so few points that triangulation leaves some triangles without area.
  scenes.emplace_back(Scene{}, 4);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<glm::dvec3> corners(5 + random.below(4));
    for (glm::dvec3& corner : corners)
      corner = glm::dvec3{random.below(4), random.below(4), random.below(4)};
    scenes.back().first.add(corners, 0);
  }
  for (const auto& [scene, n] : scenes)
    for (const int f : {0, 4})
      EXPECT_EQ(static_cast<std::int64_t>(quantise(scene, f).facets.size()),
                facet::build_facets(scene, n, f, facet::Rule::armoured).counts.loaded)
          << scene.name;
}

TEST(Families, StayWithinTheirCube) {
  for (const MeshFamily& family : kMeshFamilies)
    for (int seed = 1; seed <= 200; ++seed)
      for (const glm::dvec3& vertex : make_mesh(family, seed).vertices)
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(vertex[axis], 1.0) << family.name << " " << seed;
          ASSERT_LE(vertex[axis], family.n - 2.0) << family.name << " " << seed;
        }
}

// Inside is z = 0, and so is the occupied layer, with holes.
TEST(Tunnels, AreCountedByNeighbourhood) {
  constexpr int kSide = 5;
  VoxelArray<std::int32_t> winding(kSide);
  VoxelSet occupied(kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) winding[{x, y, 0}] = occupied[{x, y, 0}] = 1;
  EXPECT_EQ(count_tunnels(occupied, winding).by_26, 0);

  occupied[{2, 2, 0}] = 0;
  winding[{2, 2, 0}] = -1;  // the inside of what is inside out
  Tunnels tunnels = count_tunnels(occupied, winding);
  EXPECT_EQ(tunnels.by_6, 1);
  EXPECT_EQ(tunnels.by_18, 5);
  EXPECT_EQ(tunnels.by_26, 9);

  occupied[{0, 0, 0}] = 0;  // in a corner of the cube
  occupied[{2, 2, 1}] = 1;
  tunnels = count_tunnels(occupied, winding);
  EXPECT_EQ(tunnels.by_6, 0 + 1);
  EXPECT_EQ(tunnels.by_18, 4 + 3);
  EXPECT_EQ(tunnels.by_26, 8 + 4);
}

// Adds up what is found over many meshes.
class Total {
 public:
  void add(const Scene& scene, int n) {
    const LeakRow row = find_leaks(scene, n);
    for (std::size_t i = 0; i < row.size(); ++i) {
      by_6_[i] += row[i].tunnels.by_6;
      by_26_[i] += row[i].tunnels.by_26;
    }
  }
  std::int64_t by_6(Discretiser discretiser) const {
    return by_6_[static_cast<std::size_t>(discretiser)];
  }
  std::int64_t by_26(Discretiser discretiser) const {
    return by_26_[static_cast<std::size_t>(discretiser)];
  }
  void expect_watertight(const std::string& name) const {
    EXPECT_EQ(by_26(Discretiser::armoured), 0) << name;
    EXPECT_EQ(by_26(Discretiser::supercover), 0) << name;
    EXPECT_EQ(by_6(Discretiser::naive), 0) << name;
  }

 private:
  std::array<std::int64_t, kDiscretisers.size()> by_6_{}, by_26_{};
};

TEST(Leaks, RulesKeepTheirPromiseAndTheThesisLeaks) {
  for (const MeshFamily& family : kMeshFamilies) {
    Total total;
    const int meshes = family.n < kModelSide ? 10 : 2;
    for (int seed = 1; seed <= meshes; ++seed) total.add(make_mesh(family, 1000 + seed), family.n);
    total.expect_watertight(family.name);
    EXPECT_GT(total.by_26(Discretiser::bilinear), 0) << family.name;
    if (family.name == std::string("axis boxes")) continue;  // nothing is oblique there
    for (const Discretiser leaky :
         {Discretiser::naive, Discretiser::half, Discretiser::blindee, Discretiser::slices})
      EXPECT_GT(total.by_26(leaky), 0) << family.name << " " << to_string(leaky);
  }
}

TEST(Leaks, OfModelsFromFiles) {
  Total total;
  for (const char* name : kClosedModels) total.add(closed_model(name), kModelSide);
  total.expect_watertight("models");
  for (const Discretiser leaky :
       {Discretiser::half, Discretiser::blindee, Discretiser::bilinear, Discretiser::slices}) {
    EXPECT_GT(total.by_6(leaky), 0) << to_string(leaky);
    EXPECT_GT(total.by_26(leaky), 0) << to_string(leaky);
  }
}

TEST(Leaks, RefusesAMeshThatIsNotClosed) {
  Scene scene = box(glm::dvec3(2), glm::dvec3(6));
  scene.name = "lid";
  scene.vertices.resize(scene.first[5]);
  scene.first.resize(6);
  scene.material.resize(5);
  try {
    find_leaks(scene, 9);
    FAIL() << "a box without its lid has no inside";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find("lid: "), 0U);
  }
}

using Voxels = std::set<std::tuple<int, int, int>>;
using Fill = void (*)(const Border&, VoxelSet&);

Voxels filled(Fill fill, const Border& border) {
  constexpr int kSide = 16;
  VoxelSet set(kSide);
  fill(border, set);
  Voxels voxels;
  for (int z = 0; z < kSide; ++z)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        if (set[{x, y, z}] != 0) voxels.emplace(x, y, z);
  return voxels;
}

// Voxels x, y, low..high.
struct Dexel {
  int x, y, low, high;
};

Voxels dexels(std::initializer_list<Dexel> list) {
  Voxels voxels;
  for (const auto& [x, y, low, high] : list)
    for (int z = low; z <= high; ++z) voxels.emplace(x, y, z);
  return voxels;
}

TEST(Discretisers, AgreeInThePlaneOfTheScreen) {
  const Border border = {{0, 0, 3}, {3, 0, 3}, {0, 3, 3}};
  const Voxels expected = dexels({{0, 3, 3, 3},
                                  {0, 2, 3, 3},
                                  {1, 2, 3, 3},
                                  {0, 1, 3, 3},
                                  {1, 1, 3, 3},
                                  {2, 1, 3, 3},
                                  {0, 0, 3, 3},
                                  {1, 0, 3, 3},
                                  {2, 0, 3, 3},
                                  {3, 0, 3, 3}});
  EXPECT_EQ(filled(fill_bilinear, border), expected);
  EXPECT_EQ(filled(fill_slices, border), expected);
}

// z = 3x: each line and each slice is a steep segment, of which every column gets one voxel.
TEST(Discretisers, TearWhereZRisesWithX) {
  const Border border = {{0, 2, 0}, {0, 0, 0}, {2, 0, 6}};
  const Voxels expected =
      dexels({{0, 2, 0, 0}, {0, 1, 0, 0}, {1, 1, 3, 3}, {0, 0, 0, 0}, {1, 0, 3, 3}, {2, 0, 6, 6}});
  EXPECT_EQ(filled(fill_bilinear, border), expected);
  EXPECT_EQ(filled(fill_slices, border), expected);
}

// z = 3(2 - y): slices have an extent in z, lines have not.
TEST(Discretisers, DifferWhereZRisesWithY) {
  const Border border = {{0, 2, 0}, {0, 0, 6}, {2, 0, 6}};
  EXPECT_EQ(
      filled(fill_bilinear, border),
      dexels({{0, 2, 0, 0}, {0, 1, 3, 3}, {1, 1, 3, 3}, {0, 0, 6, 6}, {1, 0, 6, 6}, {2, 0, 6, 6}}));
  EXPECT_EQ(
      filled(fill_slices, border),
      dexels({{0, 2, 0, 0}, {0, 1, 0, 3}, {1, 1, 3, 3}, {0, 0, 3, 6}, {1, 0, 3, 6}, {2, 0, 6, 6}}));
}

TEST(Discretisers, RoundToTheNearestAndTiesUp) {
  EXPECT_EQ(filled(fill_bilinear, {{0, 0, 0}, {3, 0, 1}, {0, 1, 0}}),
            dexels({{0, 1, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {2, 0, 1, 1}, {3, 0, 1, 1}}));
  // At y = 1 the right side is at x = 3/2, z = 1/2.
  const Border tie = {{0, 0, 0}, {3, 0, 1}, {0, 2, 0}};
  EXPECT_EQ(filled(fill_bilinear, tie), dexels({{0, 2, 0, 0},
                                                {0, 1, 0, 0},
                                                {1, 1, 0, 0},
                                                {2, 1, 1, 1},
                                                {0, 0, 0, 0},
                                                {1, 0, 0, 0},
                                                {2, 0, 1, 1},
                                                {3, 0, 1, 1}}));
}

// The tip of a triangle lies between two columns of its slice: the print divides by zero.
TEST(Slices, PassATip) {
  EXPECT_EQ(filled(fill_slices, {{0, 0, 0}, {4, 0, 0}, {2, 2, 4}}), dexels({{2, 2, 4, 4},
                                                                            {1, 1, 2, 2},
                                                                            {2, 1, 2, 4},
                                                                            {3, 1, 2, 2},
                                                                            {0, 0, 0, 0},
                                                                            {1, 0, 0, 2},
                                                                            {2, 0, 0, 2},
                                                                            {3, 0, 0, 2},
                                                                            {4, 0, 0, 0}}));
}

TEST(Discretisers, OfASingleColumn) {
  const Border border = {{1, 0, 0}, {1, 2, 0}, {1, 0, 4}};
  EXPECT_EQ(filled(fill_slices, border), dexels({{1, 2, 0, 0}, {1, 1, 0, 2}, {1, 0, 0, 4}}));
  EXPECT_EQ(filled(fill_bilinear, border), dexels({{1, 2, 0, 0}, {1, 1, 0, 0}, {1, 0, 0, 0}}));
}

TEST(Discretisers, OfASingleLine) {
  const Border border = {{0, 1, 0}, {2, 1, 0}, {2, 1, 2}, {0, 1, 4}};
  EXPECT_EQ(filled(fill_slices, border), dexels({{0, 1, 0, 4}, {1, 1, 0, 3}, {2, 1, 0, 2}}));
  EXPECT_EQ(filled(fill_bilinear, border), dexels({{0, 1, 0, 0}, {1, 1, 1, 1}, {2, 1, 2, 2}}));
}

// A facet's voxels do not depend on where its border begins or which way it turns, and lie within
// its box.
TEST(Discretisers, SeeTheFacetAndNotItsBorder) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    Border border;
    const int span = 3 + random.below(13);
    for (int k = 0; k < 3; ++k) {
      const int x = random.below(span), y = random.below(span), z = random.below(span);
      border.emplace_back(x, y, z);
    }
    facet::clean(border);
    if (border.size() < 3) continue;
    for (const Fill fill : {fill_bilinear, fill_slices}) {
      const Voxels expected = filled(fill, border);
      Border turned = border;
      for (int turn = 0; turn < 6; ++turn) {
        std::rotate(turned.begin(), turned.begin() + 1, turned.end());
        if (turn == 3) std::reverse(turned.begin(), turned.end());
        ASSERT_EQ(filled(fill, turned), expected);
      }
      for (int axis = 0; axis < 3; ++axis) {
        const auto by_axis = [&](const Vertex& a, const Vertex& b) { return a[axis] < b[axis]; };
        const auto [low, high] = std::minmax_element(border.begin(), border.end(), by_axis);
        for (const auto& [x, y, z] : expected) {
          ASSERT_GE((glm::ivec3(x, y, z)[axis]), (*low)[axis]);
          ASSERT_LE((glm::ivec3(x, y, z)[axis]), (*high)[axis]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace rc2::surface
