#include "tb/load/facet_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <set>

#include "sw/base/config.h"
#include "tb/load/facet_case.h"

namespace rc2::facet {
namespace {

const std::vector<int> kSides{2, 4, 5, 16, 31, 64, 256, 1000, 1024};

template <typename Visit>
void for_each_facet(FacetClass kind, int seeds, Visit visit) {
  for (const int n : kSides)
    for (int f = 0; f <= kMaxFractionBits; ++f)
      for (int seed = 0; seed < seeds; ++seed)
        for (const Border& border :
             generate_facets(kind, Cube{n, f}, static_cast<std::uint64_t>(seed)))
          visit(border, Cube{n, f});
}

double aspect(const Border& border) {
  std::int64_t longest = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const Vertex side = border[(i + 1) % border.size()] - border[i];
    longest = std::max(longest, dot(side, side));
  }
  return static_cast<double>(longest) / glm::length(glm::dvec3(doubled_area(border)));
}

class EveryClass : public testing::TestWithParam<FacetClass> {};

TEST_P(EveryClass, IsPlanarConvexAndWithinTheCube) {
  for_each_facet(GetParam(), 100, [&](const Border& border, const Cube& cube) {
    for (const Vertex& v : border)
      ASSERT_EQ(v, glm::clamp(v, Vertex(cube.low()), Vertex(cube.high())));
    Border corners = border;
    clean(corners);
    ASSERT_EQ(corners.size() >= 3, has_area(border));
    if (has_area(border)) {
      ASSERT_TRUE(is_planar_convex(corners)) << describe(border, cube);
      ASSERT_LE(corners.size(), 16U);
    } else {
      ASSERT_EQ(GetParam(), FacetClass::collinear);
    }
  });
}

TEST_P(EveryClass, DependsOnItsSeedOnly) {
  const Cube cube{64, 4};
  EXPECT_EQ(generate_facets(GetParam(), cube, 7), generate_facets(GetParam(), cube, 7));
  std::set<std::int64_t> different;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    different.insert(generate_facets(GetParam(), cube, seed)[0][0].x);
  EXPECT_GT(different.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Classes, EveryClass, testing::ValuesIn(kFacetClasses),
                         [](const auto& kind) {
                           std::string name = to_string(kind.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// A sum over all vertices: another compiler or library would change it if anything differed.
TEST(FacetGenerator, GivesTheSameFacetsEverywhere) {
  std::uint64_t sum = 0;
  for (const FacetClass kind : kFacetClasses)
    for_each_facet(kind, 3, [&](const Border& border, const Cube&) {
      for (const Vertex& v : border)
        for (int i = 0; i < 3; ++i) sum = (sum ^ static_cast<std::uint64_t>(v[i])) * 0x100000001B3;
    });
  EXPECT_EQ(sum, 17607413846433020225U);
}

TEST(FacetGenerator, GoesToExtremes) {
  double thinnest = 0;
  for_each_facet(FacetClass::sliver, 100, [&](const Border& border, const Cube&) {
    thinnest = std::max(thinnest, aspect(border));
  });
  EXPECT_GT(thinnest, 1e6);

  std::set<std::size_t> sides;
  for_each_facet(FacetClass::many_sided, 100,
                 [&](const Border& border, const Cube&) { sides.insert(border.size()); });
  EXPECT_EQ(sides.size(), 14U) << "3 to 16";

  std::int64_t lines = 0, facets = 0;
  for_each_facet(FacetClass::collinear, 100, [&](const Border& border, const Cube&) {
    ++facets;
    lines += has_area(border) ? 0 : 1;
  });
  EXPECT_GT(lines, facets / 16);
  EXPECT_LT(lines, facets / 4);
}

TEST(FacetGenerator, KeepsItsPromises) {
  for_each_facet(FacetClass::single_voxel, 100, [&](const Border& border, const Cube& cube) {
    if (cube.fraction_bits == 0) return;
    for (const Vertex& v : border)
      for (const Vertex& w : border)
        for (int axis = 0; axis < 3; ++axis) ASSERT_LE(v[axis] - w[axis], cube.one());
  });
  for_each_facet(FacetClass::edge_on, 100, [&](const Border& border, const Cube&) {
    const Vertex area = doubled_area(border);
    ASSERT_TRUE(area.x == 0 || area.y == 0 || area.z == 0);
  });
  for_each_facet(FacetClass::half_integer, 100, [&](const Border& border, const Cube& cube) {
    for (const Vertex& v : border)
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_EQ(v[axis] % std::max<std::int64_t>(1, cube.one() / 2), 0);
  });
  for_each_facet(FacetClass::full_cube, 100, [&](const Border& border, const Cube& cube) {
    bool spans = false;
    for (int axis = 0; axis < 3; ++axis)
      for (const Vertex& v : border) spans |= v[axis] == cube.low() || v[axis] == cube.high();
    ASSERT_TRUE(spans);
  });
  for (const int n : kSides) {
    const std::vector<Border> four = generate_facets(FacetClass::duplicates, Cube{n, 3}, 5);
    ASSERT_EQ(four.size(), 4U);
    for (const Border& border : four)
      EXPECT_EQ(cross(doubled_area(border), doubled_area(four[0])), Vertex(0));
  }
}

}  // namespace
}  // namespace rc2::facet
