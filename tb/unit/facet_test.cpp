#include "sw/facet/facet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/facet/polygon.h"
#include "tb/load/dice.h"
#include "tb/unit/facet_oracle.h"
#include "tb/unit/voxel_set.h"

namespace rc2::facet {
namespace {

constexpr Rule kRules[] = {Rule::armoured, Rule::naive, Rule::supercover, Rule::half,
                           Rule::blindee};

// The cube [-1/2, n-1/2]^3 in vertex units.
struct Cube {
  int n, fraction_bits;
  std::int64_t one() const { return std::int64_t{1} << fraction_bits; }
  std::int64_t low() const { return -(one() / 2); }
  std::int64_t high() const { return n * one() - (one() + 1) / 2; }
};

scene::Scene scene_of(const Border& border, const Cube& cube) {
  scene::Scene scene;
  scene.materials.resize(1);
  std::vector<glm::dvec3> corners;
  for (const Vertex& v : border) corners.push_back(glm::dvec3(v) / static_cast<double>(cube.one()));
  scene.add(corners, 0);
  return scene;
}

bool has_area(const Border& border) { return doubled_area(border) != Vertex(0); }

Vertex random_vertex(Dice& dice, const Cube& cube) {
  return {dice.roll(cube.low(), cube.high()), dice.roll(cube.low(), cube.high()),
          dice.roll(cube.low(), cube.high())};
}

Vertex clamped(const Vertex& v, const Cube& cube) {
  return glm::clamp(v, Vertex(cube.low()), Vertex(cube.high()));
}

// Corners of the convex hull of random points of a lattice plane: three to eight sides, planar.
Border random_polygon(Dice& dice, const Cube& cube) {
  using Flat = std::pair<std::int64_t, std::int64_t>;
  const std::int64_t span = 8;
  std::vector<Flat> points(12);
  for (Flat& p : points) p = {dice.roll(0, span), dice.roll(0, span)};
  std::sort(points.begin(), points.end());
  const auto turn = [](const Flat& a, const Flat& b, const Flat& c) {
    return (b.first - a.first) * (c.second - b.second) -
           (b.second - a.second) * (c.first - b.first);
  };
  std::vector<Flat> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Flat& p : points) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  const std::int64_t step = (cube.high() - cube.low()) / (2 * span);
  const auto random_step = [&] {
    return Vertex(dice.roll(-step, step), dice.roll(-step, step), dice.roll(-step, step));
  };
  const Vertex along = random_step(), across = random_step();
  Border border;
  Vertex low(0), high(0);
  for (const auto& [s, t] : hull) {
    border.push_back(s * along + t * across);
    low = border.size() == 1 ? border[0] : glm::min(low, border.back());
    high = border.size() == 1 ? border[0] : glm::max(high, border.back());
  }
  Vertex move;
  for (int axis = 0; axis < 3; ++axis)
    move[axis] = dice.roll(cube.low() - low[axis], cube.high() - high[axis]);
  for (Vertex& v : border) v += move;
  return border;
}

enum class Kind { random, tiny, sliver, edge_on, axis_aligned, corners, polygon };
constexpr Kind kKinds[] = {Kind::random,       Kind::tiny,    Kind::sliver, Kind::edge_on,
                           Kind::axis_aligned, Kind::corners, Kind::polygon};

Border random_border(Dice& dice, const Cube& cube, Kind kind) {
  const std::int64_t one = cube.one();
  Border b{random_vertex(dice, cube), random_vertex(dice, cube), random_vertex(dice, cube)};
  const int axis = static_cast<int>(dice.roll(0, 2));
  switch (kind) {
    case Kind::random:
      break;
    case Kind::tiny:  // within a voxel or so
      for (Vertex& v : b)
        v = clamped(b[0] + Vertex(dice.roll(-one, one), dice.roll(-one, one), dice.roll(-one, one)),
                    cube);
      break;
    case Kind::sliver:
      b[2] = clamped(b[1] + Vertex(dice.roll(-1, 1), dice.roll(-1, 1), dice.roll(-one, one)), cube);
      break;
    case Kind::edge_on:  // contains an axis
      b[1] = b[0];
      b[1][axis] = dice.roll(cube.low(), cube.high());
      break;
    case Kind::axis_aligned: {  // on half or whole voxels, where ties are
      const std::int64_t half = std::max<std::int64_t>(1, one / 2);
      const std::int64_t level = dice.roll(cube.low() / half, cube.high() / half) * half;
      for (Vertex& v : b) {
        v = v / half * half;
        v[axis] = level;
      }
      if (dice.roll(0, 1) == 0) {
        const int u = (axis + 1) % 3;
        b = {b[0], b[0], b[1], b[1]};
        b[1][u] = b[2][u];
        b[3][u] = b[0][u];
      }
      break;
    }
    case Kind::corners:  // corners and edges of the cube itself
      for (Vertex& v : b)
        for (int i = 0; i < 3; ++i)
          if (dice.roll(0, 3) != 0) v[i] = dice.roll(0, 1) == 0 ? cube.low() : cube.high();
      break;
    case Kind::polygon:
      return random_polygon(dice, cube);
  }
  return b;
}

// Number of voxels on which packet and oracle disagree. Outside the box and two voxels around it
// nothing is looked at unless the cube is small.
std::size_t differences(const Border& border, const Cube& cube, Rule rule) {
  const FacetSet set = build_facets(scene_of(border, cube), cube.n, cube.fraction_bits, rule);
  EXPECT_EQ(set.counts.triangulated, 0);
  EXPECT_LE(set.packets.heads.size(), 1U);
  const Oracle oracle(border, cube.one(), rule);
  glm::ivec3 from(0), to(cube.n - 1);
  if (cube.n > 10) {
    for (int axis = 0; axis < 3; ++axis) {
      std::int64_t low = border[0][axis], high = low;
      for (const Vertex& v : border) {
        low = std::min(low, v[axis]);
        high = std::max(high, v[axis]);
      }
      from[axis] = std::max(0, static_cast<int>(low / cube.one()) - 2);
      to[axis] = std::min(cube.n - 1, static_cast<int>(high / cube.one()) + 2);
    }
  }
  std::size_t count = 0;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        const glm::ivec3 p(x, y, z);
        const bool packed =
            !set.packets.heads.empty() && is_inside(set.packets, set.packets.heads[0], p);
        count += packed != oracle.has(p);
      }
  return count;
}

class EveryRule : public testing::TestWithParam<Rule> {};

TEST_P(EveryRule, EqualsTheOracleOnTheWholeGrid) {
  Dice dice(1);
  for (int i = 0; i < 2500; ++i) {
    const Kind kind = kKinds[i % std::size(kKinds)];
    const Cube cube{static_cast<int>(dice.roll(4, 9)), static_cast<int>(dice.roll(0, 8))};
    const Border border = random_border(dice, cube, kind);
    if (border.size() < 3 || !has_area(border)) continue;
    ASSERT_EQ(differences(border, cube, GetParam()), 0U)
        << "facet " << i << ", n = " << cube.n << ", f = " << cube.fraction_bits;
  }
}

TEST_P(EveryRule, EqualsTheOracleInLargeCubes) {
  Dice dice(2);
  for (const int n : {16, 33, 64, 1000}) {
    for (int i = 0; i < 200; ++i) {
      // Only small facets, or thin ones along an axis: their boxes have few voxels.
      const Cube cube{n, static_cast<int>(dice.roll(0, 8))};
      Border border = random_border(dice, cube, i % 2 == 0 ? Kind::tiny : Kind::random);
      const std::int64_t reach = 3 * cube.one();
      for (std::size_t k = 1; k < border.size(); ++k)
        border[k] = clamped(glm::clamp(border[k], border[0] - reach, border[0] + reach), cube);
      if (!has_area(border)) continue;
      ASSERT_EQ(differences(border, cube, GetParam()), 0U)
          << "facet " << i << ", n = " << n << ", f = " << cube.fraction_bits;
    }
  }
}

// A facet on whole voxels is the same facet however finely vertices are counted.
TEST_P(EveryRule, DoesNotDependOnTheScale) {
  Dice dice(3);
  for (int i = 0; i < 200; ++i) {
    const Cube coarse{8, 0};
    const Border border = random_border(dice, coarse, i % 2 == 0 ? Kind::random : Kind::polygon);
    if (border.size() < 3 || !has_area(border)) continue;
    const scene::Scene scene = scene_of(border, coarse);
    const VoxelSet a(build_facets(scene, 8, 0, GetParam()).packets, 8);
    const VoxelSet b(build_facets(scene, 8, kMaxFractionBits, GetParam()).packets, 8);
    for (int k = 0; k < 512; ++k)
      ASSERT_EQ(a.has({k % 8, k / 8 % 8, k / 64}), b.has({k % 8, k / 8 % 8, k / 64})) << i;
  }
}

bool fits(std::int64_t value, int bits) {
  const std::int64_t limit = std::int64_t{1} << (bits - 1);
  return value >= -limit && value < limit;
}

void expect_narrow(const PacketStream& stream, const Cube& cube) {
  const int n = cube.n, f = cube.fraction_bits;
  for (const PacketHead& head : stream.heads) {
    const glm::ivec3 size = head.hi - head.lo;
    const auto expect_fits = [&](const Linear& value, int bits) {
      for (const std::int64_t c : {value.a, value.b, value.c}) ASSERT_TRUE(fits(c, bits)) << c;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 at(corner & 1 ? size.x : 0, corner & 2 ? size.y : 0,
                            corner & 4 ? size.z : 0);
        ASSERT_TRUE(fits(value_at(value, at), offset_bits(n, f))) << value_at(value, at);
      }
    };
    expect_fits(head.slab.value, plane_bits(n, f));
    ASSERT_GE(head.slab.width, 0);
    ASSERT_EQ(head.slab.width >> plane_bits(n, f), 0) << head.slab.width;
    for (const std::int64_t c : {head.gap.a, head.gap.b, head.gap.c})
      ASSERT_TRUE(fits(c, gap_value_bits(n))) << c;
    for (std::uint32_t k = 0; k < head.side_count; ++k) {
      const Side& side = stream.sides[head.first_side + k];
      expect_fits(side.value, side_bits(n, f));
      ASSERT_GE(side.push, 0);
      ASSERT_EQ(side.push >> push_bits(n, f), 0) << side.push;
    }
  }
}

TEST_P(EveryRule, FitsTheWidthsOfTheMachine) {
  Dice dice(4);
  for (const int n : {2, 3, 5, 16, 63, 64, 255, 256, 1000, 1024}) {
    for (int f = 0; f <= kMaxFractionBits; ++f) {
      const Cube cube{n, f};
      SCOPED_TRACE("n = " + std::to_string(n) + ", f = " + std::to_string(f));
      for (int i = 0; i < 120; ++i) {
        constexpr Kind kLarge[] = {Kind::random, Kind::corners, Kind::polygon};
        const Border border = random_border(dice, cube, kLarge[i % 3]);
        if (border.size() < 3 || !has_area(border)) continue;
        expect_narrow(build_facets(scene_of(border, cube), n, f, GetParam()).packets, cube);
        if (HasFatalFailure()) return;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRule, testing::ValuesIn(kRules),
                         [](const auto& rule) { return std::string(to_string(rule.param)); });

TEST(BuildFacets, WritesASlabAndASideForEachEdge) {
  // z = 1 with half a voxel on each side; the upper end is not included.
  const Cube cube{8, 1};
  const FacetSet set =
      build_facets(scene_of({{4, 4, 2}, {8, 4, 2}, {8, 8, 2}, {4, 8, 2}}, cube), 8, 1, Rule::naive);
  ASSERT_EQ(set.packets.heads.size(), 1U);
  const PacketHead& head = set.packets.heads[0];
  EXPECT_EQ(head.lo, glm::ivec3(2, 2, 1));
  EXPECT_EQ(head.hi, glm::ivec3(4, 4, 1));
  EXPECT_EQ(head.side_count, 4U);
  EXPECT_GT(head.slab.value.c, 0);
  EXPECT_GE(head.slab.value.d, 0);
  EXPECT_LE(head.slab.value.d, head.slab.width);
  EXPECT_EQ(set.facets[0].normal, glm::vec3(0, 0, 1));
}

TEST(BuildFacets, KeepsConvexPolygonsAndSplitsOthers) {
  const Cube cube{16, 4};
  const auto count = [&](const Border& border) {
    return build_facets(scene_of(border, cube), 16, 4, Rule::armoured).counts;
  };
  const FacetCounts octagon = count({{40, 32, 8},
                                     {64, 32, 8},
                                     {80, 48, 8},
                                     {80, 72, 8},
                                     {64, 88, 8},
                                     {40, 88, 8},
                                     {24, 72, 8},
                                     {24, 48, 8}});
  EXPECT_EQ(octagon.loaded, 1);
  EXPECT_EQ(octagon.triangulated, 0);
  const FacetCounts bent = count({{0, 0, 0}, {64, 0, 0}, {64, 64, 1}, {0, 64, 0}});
  EXPECT_EQ(bent.loaded, 2);
  EXPECT_EQ(bent.triangulated, 1);
  const FacetCounts concave =
      count({{0, 0, 0}, {64, 0, 0}, {64, 32, 0}, {32, 32, 0}, {32, 64, 0}, {0, 64, 0}});
  EXPECT_EQ(concave.loaded, 4);
  EXPECT_EQ(concave.triangulated, 1);
  const FacetCounts dart = count({{0, 0, 0}, {64, 0, 0}, {32, 16, 0}, {0, 64, 0}});
  EXPECT_EQ(dart.loaded, 2);
  EXPECT_EQ(dart.triangulated, 1);
  // Goes round twice: every corner turns the same way, and yet it is not convex.
  const FacetCounts star =
      count({{64, 0, 0}, {96, 112, 0}, {0, 40, 0}, {128, 40, 0}, {24, 112, 0}});
  EXPECT_EQ(star.triangulated, 1);
}

// Twice the area of such a wall has a bit more than coefficients have, but only in common factors.
TEST(BuildFacets, LoadsWallsAsLargeAsTheCube) {
  for (const int n : {2, 16, 64, 1024}) {
    const Cube cube{n, 4};
    const std::int64_t low = cube.low(), high = cube.high();
    const Border wall{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}};
    const Border ramp{{low, low, low}, {high, low, low}, {high, high, high}, {low, high, high}};
    for (const Border& border : {wall, ramp})
      EXPECT_EQ(build_facets(scene_of(border, cube), n, 4, Rule::armoured).counts.loaded, 1) << n;
  }
}

TEST(BuildFacets, CountsWhatItDrops) {
  scene::Scene scene;
  scene.name = "counting";
  scene.materials.resize(2);
  scene.add({{1, 1, 1}, {3, 1, 1}, {1, 3, 1}}, 1);
  scene.add({{1, 1, 1}, {3, 1, 1}, {5, 1, 1}}, 0);           // no area
  scene.add({{1, 1, 1}, {1.001, 1, 1}, {1, 1.001, 1}}, 0);   // none after rounding
  scene.add({{20, 1, 1}, {22, 1, 1}, {20, 3, 1}}, 0);        // beside the cube
  scene.add({{-9, 8, 4}, {8, -11, 4}, {-90, -90, 4}}, 0);    // passes a corner of the cube
  scene.add({{-0.5, 1, 1}, {-0.5, 3, 1}, {-0.5, 1, 3}}, 0);  // on the border, of no voxel
  scene.add({{1, 1, 1}, {1, 1, 1}, {3, 1, 1}, {4, 1, 1}, {5, 1, 1}, {1, 5, 1}}, 1);
  const FacetSet set = build_facets(scene, 8, 4, Rule::armoured);
  EXPECT_EQ(set.counts.read, 7);
  EXPECT_EQ(set.counts.loaded, 2);
  EXPECT_EQ(set.counts.degenerate, 2);
  EXPECT_EQ(set.counts.outside, 3);
  EXPECT_EQ(set.counts.triangulated, 0);
  ASSERT_EQ(set.facets.size(), 2U);
  EXPECT_EQ(set.facets[1].material, 1U);
  EXPECT_EQ(set.packets.heads[1].facet, 1U);
  EXPECT_EQ(set.packets.heads[1].side_count, 3U) << "repeated and collinear vertices are no sides";
}

std::string error_of(const std::vector<glm::dvec3>& corners) {
  scene::Scene scene;
  scene.name = "broken";
  scene.materials.resize(1);
  scene.add({{1, 1, 1}, {3, 1, 1}, {1, 3, 1}}, 0);
  scene.add(corners, 0);
  try {
    build_facets(scene, 8, 4, Rule::armoured);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(BuildFacets, NamesThePolygonThatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    const std::string message = error_of({{1, 1, 1}, {bad, 1, 1}, {1, 3, 1}});
    EXPECT_NE(message.find("broken: polygon 1 "), std::string::npos) << message;
  }
  for (const glm::dvec3& far :
       {glm::dvec3(8, 1, 1), glm::dvec3(1, -0.6, 1), glm::dvec3(1, 1, 1e300)}) {
    const std::string message = error_of({{1, 1, 2}, far, {1, 3, 1}});
    EXPECT_NE(message.find("broken: polygon 1 "), std::string::npos) << message;
    EXPECT_NE(message.find("--fit cube"), std::string::npos) << message;
  }
  EXPECT_EQ(error_of({{-0.5, 1, 2}, {7.5, 1, 2}, {1, 7.5, 1}}), "") << "the border belongs to it";
}

TEST(BuildFacets, RefusesSizesBeyondTheProof) {
  const scene::Scene scene;
  EXPECT_THROW(build_facets(scene, 1, 4, Rule::armoured), Error);
  EXPECT_THROW(build_facets(scene, kMaxSide + 1, 4, Rule::armoured), Error);
  EXPECT_THROW(build_facets(scene, 16, -1, Rule::armoured), Error);
  EXPECT_THROW(build_facets(scene, 16, kMaxFractionBits + 1, Rule::armoured), Error);
  EXPECT_EQ(build_facets(scene, 16, 4, Rule::armoured).counts.loaded, 0);
}

TEST(ParseRule, KnowsFiveWords) {
  for (const Rule rule : kRules) EXPECT_EQ(parse_rule(to_string(rule)), rule);
  EXPECT_THROW(parse_rule("Armoured"), Error);
  EXPECT_THROW(parse_rule(""), Error);
}

TEST(Clean, LeavesOnlyCorners) {
  Border border{{2, 0, 0}, {4, 0, 0}, {4, 0, 0}, {4, 4, 0}, {9, 4, 0}, {4, 4, 0},
                {2, 4, 0}, {0, 4, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  clean(border);
  EXPECT_EQ(border, (Border{{4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}}));
  Border line{{0, 0, 0}, {1, 1, 1}, {5, 5, 5}, {2, 2, 2}};
  clean(line);
  EXPECT_LT(line.size(), 3U);
}

// A simple polygon of any shape: random points sorted by direction around the origin.
Border random_star(Dice& dice, int corners) {
  std::vector<std::pair<double, Vertex>> points;
  while (static_cast<int>(points.size()) < corners) {
    const Vertex v(dice.roll(-100, 100), dice.roll(-100, 100), 0);
    const double angle = std::atan2(static_cast<double>(v.y), static_cast<double>(v.x));
    const bool repeated = std::any_of(points.begin(), points.end(), [&](const auto& other) {
      return std::abs(other.first - angle) < 1e-9;
    });
    if (v != Vertex(0) && !repeated) points.emplace_back(angle, v);
  }
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  Border border;
  for (const auto& [angle, v] : points) border.push_back(v);
  clean(border);
  return border;
}

TEST(Triangulate, CoversSimplePolygonsOnce) {
  Dice dice(5);
  for (int i = 0; i < 300; ++i) {
    Border border = random_star(dice, static_cast<int>(dice.roll(12, 24)));
    const std::int64_t area = doubled_area(border).z;
    if (area <= 0) continue;  // the origin may lie outside: then the order is not simple
    // Tilted, so that the projection along the dominant axis is put to use.
    for (Vertex& v : border) v = {v.y, 3 * v.x + v.y, v.x};
    const Vertex normal = doubled_area(border);
    std::vector<Triangle> triangles;
    triangulate(border, triangles);
    ASSERT_EQ(triangles.size(), border.size() - 2);
    Vertex sum(0);
    for (const auto& [a, b, c] : triangles) {
      const Vertex piece = cross(b - a, c - b);
      ASSERT_GE(dot(piece, normal), 0) << "no piece is turned over";
      sum += piece;
    }
    ASSERT_EQ(sum, normal);
  }
}

TEST(Triangulate, KeepsEverySideOfAnyBorder) {
  Dice dice(6);
  for (int i = 0; i < 300; ++i) {
    Border border;
    for (std::int64_t k = dice.roll(4, 12); k > 0; --k)
      border.emplace_back(dice.roll(0, 9), dice.roll(0, 9), dice.roll(0, 9));
    clean(border);
    if (border.size() < 4) continue;
    std::vector<Triangle> triangles;
    triangulate(border, triangles);
    ASSERT_EQ(triangles.size(), border.size() - 2);
    // Inner sides cancel, so what is left is the border: compare its area as a vector.
    Vertex sum(0);
    for (const auto& [a, b, c] : triangles) sum += cross(b - a, c - b);
    ASSERT_EQ(sum, doubled_area(border));
  }
}

TEST(Generated, DustOccupiesExactlyItsVoxels) {
  for (const Rule rule : {Rule::armoured, Rule::naive, Rule::half, Rule::blindee}) {
    for (const int f : {1, 4, 8}) {
      const scene::Scene scene = scene::generate("dust:20:3", 12);
      const FacetSet set = build_facets(scene, 12, f, rule);
      ASSERT_EQ(set.counts.loaded, static_cast<std::int64_t>(scene.polygon_count()));
      const VoxelSet voxels(set.packets, 12);
      EXPECT_EQ(voxels.count(), scene.polygon_count());
      for (std::size_t i = 0; i < scene.polygon_count(); ++i)
        ASSERT_TRUE(voxels.has(scene.vertices[scene.first[i]]));
    }
  }
}

TEST(Generated, ShellsCoverTheShareTheyPromise) {
  for (const auto& [n, percent] : {std::pair(64, 2), std::pair(32, 10), std::pair(64, 30),
                                   std::pair(64, 50), std::pair(24, 20)}) {
    double share = 0.0;
    constexpr int kSeeds = 4;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      const scene::Scene scene =
          scene::generate("shells:" + std::to_string(percent) + ":" + std::to_string(seed), n);
      const VoxelSet voxels(build_facets(scene, n, 4, Rule::armoured).packets, n);
      share += 100.0 * static_cast<double>(voxels.count()) / (n * n * n) / kSeeds;
      for (const int x : {0, n - 1})
        for (const int y : {0, n - 1})
          for (const int z : {0, n - 1}) EXPECT_FALSE(voxels.has({x, y, z}));
    }
    EXPECT_NEAR(share, percent, 0.3 * percent) << "n = " << n;
  }
}

TEST(Generated, LightsOfRoomsAreInFreeVoxels) {
  for (int n = 16; n <= 72; n += 4) {
    for (const bool authored : {false, true}) {
      scene::Scene scene = authored ? scene::read_file(RC2_SOURCE_DIR "/sw/scene/room.dae")
                                    : scene::generate("room", n);
      if (authored) scene::fit_to_cube(scene, n);
      const FacetSet set = build_facets(scene, n, 4, Rule::armoured);
      const VoxelSet voxels(set.packets, n);
      ASSERT_FALSE(scene.lights.empty());
      for (const scene::Light& light : scene.lights)
        EXPECT_FALSE(voxels.has(glm::ivec3(glm::floor(light.position + 0.5)))) << "n = " << n;
    }
  }
}

TEST(Generated, DefaultSceneKeepsItsPolygons) {
  scene::Scene scene = scene::read_file(RC2_SOURCE_DIR "/sw/scene/room.dae");
  scene::fit_to_cube(scene, 16);
  const FacetSet set = build_facets(scene, 16, 4, Rule::armoured);
  EXPECT_EQ(set.counts.triangulated, 0);
  EXPECT_EQ(set.counts.loaded, static_cast<std::int64_t>(scene.polygon_count()));
  std::size_t many_sided = 0;
  for (const PacketHead& head : set.packets.heads) many_sided += head.side_count >= 6;
  EXPECT_GE(many_sided, 6U);
}

}  // namespace
}  // namespace rc2::facet
