// Who owns a voxel: what a packet says of core and gap against the facet's own geometry in exact
// integers, and the order of claims.
#include "sw/machine/claim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <random>

#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"
#include "sw/golden/golden_machine.h"

namespace rc2 {
namespace {

using facet::Border;
using facet::Rule;
using facet::Vertex;

constexpr Rule kRules[] = {Rule::armoured, Rule::naive, Rule::supercover, Rule::half,
                           Rule::blindee};

int pick(std::mt19937& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

struct Sample {
  int n, fraction_bits;
  Border triangle;
};

// Triangles of all sizes, some flat along an axis, some with vertices on voxel centres.
Sample random_sample(std::mt19937& random) {
  Sample sample{pick(random, 2, 20), pick(random, 0, 8), {}};
  const int one = 1 << sample.fraction_bits;
  const int high = sample.n * one - (one + 1) / 2;
  const int reach = pick(random, 0, 2) == 0 ? 2 * one : sample.n * one;
  Vertex first;
  for (int axis = 0; axis < 3; ++axis) first[axis] = pick(random, -one / 2, high);
  const int flat = pick(random, 0, 5);
  for (int k = 0; k < 3; ++k) {
    Vertex v = first;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != flat) v[axis] += pick(random, -reach, reach);
      v[axis] = std::clamp<std::int64_t>(v[axis], -one / 2, high);
      if (flat == 5) v[axis] = std::min<std::int64_t>(v[axis] / one, sample.n - 1) * one;
    }
    sample.triangle.push_back(v);
  }
  return sample;
}

scene::Scene scene_of(const std::vector<Border>& borders, int fraction_bits) {
  scene::Scene scene;
  scene.materials.resize(1);
  for (const Border& border : borders) {
    std::vector<glm::dvec3> corners;
    for (const Vertex& v : border) corners.push_back(glm::dvec3(v) / std::exp2(fraction_bits));
    scene.add(corners, 0);
  }
  return scene;
}

// Whether the gap is the signed distance from the plane to the voxel centre along the dominant
// axis, r / (K F), in sixteenths: half a one from rounding down, 3/8 from the steps.
bool is_gap_of(const Sample& sample, const VoxelRecord& voxel) {
  const Vertex normal = facet::doubled_area(sample.triangle);
  const std::int64_t one = std::int64_t{1} << sample.fraction_bits;
  const std::int64_t r = facet::dot(normal, Vertex(voxel.at) * one - sample.triangle[0]);
  const std::int64_t size =
      one * std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  return std::abs(128 * r - (8 * voxel.owner.gap + 4) * size) <= 7 * size;
}

// Whether the voxel centre, seen along the axis, lies within the triangle: 1 inside, 0 on its
// border, -1 outside.
int within(const Sample& sample, const glm::ivec3& voxel, int axis) {
  const Vertex p = Vertex(voxel) << std::int64_t{sample.fraction_bits};
  const std::int64_t turn = facet::doubled_area(sample.triangle)[axis];
  int result = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& from = sample.triangle[i];
    const std::int64_t side = facet::cross(sample.triangle[(i + 1) % 3] - from, p - from)[axis];
    const int sign = side == 0 ? 0 : (side > 0) == (turn > 0) ? 1 : -1;
    result = std::min(result, sign);
  }
  return result;
}

class EveryRule : public testing::TestWithParam<Rule> {};

TEST_P(EveryRule, ClaimsWhatTheGeometrySays) {
  std::mt19937 random(1);
  int cores = 0, fringes = 0;
  for (int i = 0; i < 3000; ++i) {
    const Sample sample = random_sample(random);
    const auto facets = facet::build_facets(scene_of({sample.triangle}, sample.fraction_bits),
                                            sample.n, sample.fraction_bits, GetParam());
    if (facets.packets.heads.empty()) continue;
    MachineConfig config;
    config.n = sample.n;
    config.fraction_bits = sample.fraction_bits;
    golden::GoldenMachine machine(config);
    machine.load(facets.packets, {});
    const Vertex normal = facet::doubled_area(sample.triangle);
    for (const VoxelRecord& voxel : machine.read_voxels()) {
      ASSERT_TRUE(is_gap_of(sample, voxel)) << "triangle " << i;

      int inside = 1;
      for (int axis = 0; axis < 3; ++axis) {
        const bool seen = GetParam() == Rule::supercover ? normal[axis] != 0
                                                         : axis == facet::dominant_axis(normal);
        if (seen) inside = std::min(inside, within(sample, voxel.at, axis));
      }
      if (inside != 0) {
        ASSERT_EQ(voxel.owner.core, inside > 0) << "triangle " << i;
      }
      ++(voxel.owner.core ? cores : fringes);
    }
  }
  EXPECT_GT(cores, 10000);
  if (GetParam() != Rule::half && GetParam() != Rule::blindee) {
    EXPECT_GT(fringes, 10000);
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRule, testing::ValuesIn(kRules),
                         [](const auto& rule) { return std::string(to_string(rule.param)); });

// Two halves of a tilted square: where both fill a voxel over the square's inside, the one below or
// above the voxel centre owns it, whichever number it has. The centre is in exactly one of them.
TEST(Owner, IsTheCoplanarNeighbourUnderTheVoxel) {
  std::mt19937 random(2);
  int shared = 0;
  for (int i = 0; i < 300; ++i) {
    const int n = 16, f = 4;
    const std::int64_t rise = pick(random, -60, 60), slant = pick(random, -60, 60);
    const auto corner = [&](std::int64_t x, std::int64_t y) {
      return Vertex(60 + x * 64, 60 + y * 64, 120 + (x * rise + y * slant));
    };
    Border first{corner(-1, -1), corner(1, -1), corner(1, 1)};
    Border second{corner(-1, -1), corner(1, 1), corner(-1, 1)};
    if (pick(random, 0, 1) == 0) std::swap(first, second);
    golden::GoldenMachine machine(MachineConfig{n, f, 64, 32, 1});
    const auto voxels_of = [&](const std::vector<Border>& borders) {
      machine.load(facet::build_facets(scene_of(borders, f), n, f, Rule::armoured).packets, {});
      return machine.read_voxels();
    };
    const VoxelMemory alone[] = {voxels_of({first}), voxels_of({second})};
    const auto fills = [&](int facet, const glm::ivec3& at) {
      return std::any_of(alone[facet].begin(), alone[facet].end(),
                         [&](const VoxelRecord& voxel) { return voxel.at == at; });
    };
    for (const VoxelRecord& voxel : voxels_of({first, second})) {
      if (!fills(0, voxel.at) || !fills(1, voxel.at)) continue;
      const bool in_first = within({n, f, first}, voxel.at, 2) > 0;
      const bool in_second = within({n, f, second}, voxel.at, 2) > 0;
      if (in_first || in_second) {
        ASSERT_EQ(voxel.owner.facet, in_first ? 0U : 1U);
      }
      ++shared;
    }
  }
  EXPECT_GT(shared, 5000);
}

TEST(Claim, PacksWithoutLoss) {
  for (const std::uint32_t facet : {0U, 1U, 77777U, kMaxFacets - 1U}) {
    for (const bool core : {false, true}) {
      for (int gap = -32; gap < 32; ++gap) {
        const std::uint32_t packed = Claim{facet, core, gap}.packed();
        EXPECT_EQ(packed >> kClaimBits, 0U);
        const Claim claim = Claim::unpacked(packed);
        EXPECT_EQ(claim.facet, facet);
        EXPECT_EQ(claim.core, core);
        EXPECT_EQ(claim.gap, gap);
      }
    }
  }
}

TEST(Claim, PrefersCoreThenThePlaneNearbyThenTheNumber) {
  const auto better = [](const Claim& a, const Claim& b) { return a.packed() < b.packed(); };
  EXPECT_TRUE(better({9, true, 31}, {1, false, 0}));
  EXPECT_TRUE(better({9, true, -2}, {1, true, 2}));
  EXPECT_TRUE(better({9, false, 4}, {1, false, -6}));
  EXPECT_TRUE(better({1, true, 3}, {9, true, -4}));
  EXPECT_TRUE(better({1, true, -4}, {9, true, 3}));
}

}  // namespace
}  // namespace rc2
