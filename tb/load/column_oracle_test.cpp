#include "tb/load/column_oracle.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "tb/load/column_oracle_impl.h"
#include "tb/load/facet_case.h"
#include "tb/unit/facet_oracle.h"

namespace rc2::facet {
namespace {

class EveryRule : public testing::TestWithParam<Rule> {};

// The unit tests' oracle looks at one voxel after the other and knows nothing of columns.
TEST_P(EveryRule, AgreesWithTheOracleOfSingleVoxels) {
  for (int number = 0; number < 3600; ++number) {
    const FacetCase drawn = draw_case(1, number, {4, 5, 7}, 1000);
    const int n = drawn.cube.n;
    for (const Border& border : drawn.borders) {
      if (!has_area(border)) continue;
      const ColumnOracle<Int128> fast(border, drawn.cube.one(), GetParam());
      const Oracle slow(border, drawn.cube.one(), GetParam());
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
          const Span span = fast.column(x, y, n).voxels;
          for (int z = 0; z < n; ++z)
            ASSERT_EQ(span.first <= z && z <= span.last, slow.has({x, y, z}))
                << "voxel (" << x << ", " << y << ", " << z << "), case " << number << ": "
                << describe(border, drawn.cube);
        }
    }
  }
}

// The narrow types lose nothing where their numbers are largest.
TEST_P(EveryRule, NeedsNoMoreBitsThanItHas) {
  using Wide = boost::multiprecision::checked_int256_t;
  for (int number = 0; number < 1800; ++number) {
    const FacetCase drawn = draw_case(2, number, {1000, 1024}, 1 << 20);
    const Border& border = drawn.borders[0];
    if (!has_area(border)) continue;
    const ColumnOracle<Wide> wide(border, drawn.cube.one(), GetParam());
    const ColumnOracle<Int128> narrow(border, drawn.cube.one(), GetParam());
    std::optional<ColumnOracle<std::int64_t>> narrowest;
    if (GetParam() != Rule::blindee) narrowest.emplace(border, drawn.cube.one(), GetParam());
    const auto [low, high] = voxels_around(border, drawn.cube, 2);
    for (int i = 0; i < 64; ++i) {
      const int x = low.x + (high.x - low.x) * (i % 8) / 7;
      const int y = low.y + (high.y - low.y) * (i / 8) / 7;
      const Column expected = wide.column(x, y, drawn.cube.n);
      ASSERT_TRUE(narrow.column(x, y, drawn.cube.n) == expected) << describe(border, drawn.cube);
      if (!narrowest) continue;
      ASSERT_TRUE(narrowest->column(x, y, drawn.cube.n) == expected)
          << describe(border, drawn.cube);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRule,
                         testing::Values(Rule::armoured, Rule::naive, Rule::supercover, Rule::half,
                                         Rule::blindee),
                         [](const auto& rule) { return std::string(to_string(rule.param)); });

}  // namespace
}  // namespace rc2::facet
