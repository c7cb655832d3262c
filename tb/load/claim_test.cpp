// Who owns a voxel. That core and gap are what the geometry says is checked by machine_check and
// golden_check.
#include "sw/machine/claim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sw/golden/golden_machine.h"
#include "tb/load/dice.h"
#include "tb/load/golden_check.h"

namespace rc2::facet {
namespace {

// Whether the voxel centre, seen along z, lies within the triangle and not on its border. The
// triangle turns left.
bool is_over(const Border& triangle, const Cube& cube, const glm::ivec3& voxel) {
  const Vertex p = Vertex(voxel) * cube.one();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& from = triangle[i];
    if (cross(triangle[(i + 1) % 3] - from, p - from).z <= 0) return false;
  }
  return true;
}

// Two halves of a tilted square: where both fill a voxel over the square's inside, the one below or
// above the voxel centre owns it, whichever number it has.
TEST(Owner, IsTheCoplanarNeighbourUnderTheVoxel) {
  const Cube cube{16, 4};
  Dice dice(2);
  int shared = 0;
  for (int i = 0; i < 300; ++i) {
    const std::int64_t rise = dice.roll(-60, 60), slant = dice.roll(-60, 60);
    const auto corner = [&](std::int64_t x, std::int64_t y) {
      return Vertex(60 + x * 64, 60 + y * 64, 120 + x * rise + y * slant);
    };
    Border first{corner(-1, -1), corner(1, -1), corner(1, 1)};
    Border second{corner(-1, -1), corner(1, 1), corner(-1, 1)};
    if (dice.one_in(2)) std::swap(first, second);
    golden::GoldenMachine machine(MachineConfig{cube.n, cube.fraction_bits, 64, 32, 1});
    const auto voxels_of = [&](const std::vector<Border>& borders) {
      const scene::Scene scene = scene_of(borders, cube);
      machine.load(build_facets(scene, cube.n, cube.fraction_bits, Rule::armoured).packets, {});
      return machine.read_voxels();
    };
    const auto has = [](const VoxelMemory& voxels, const glm::ivec3& at) {
      return std::any_of(voxels.begin(), voxels.end(),
                         [&](const VoxelRecord& voxel) { return voxel.at == at; });
    };
    const VoxelMemory of_first = voxels_of({first}), of_second = voxels_of({second});
    for (const auto& [at, owner] : voxels_of({first, second})) {
      if (!has(of_first, at) || !has(of_second, at)) continue;
      const bool in_first = is_over(first, cube, at);
      if (!in_first && !is_over(second, cube, at)) continue;
      ASSERT_EQ(owner.facet, in_first ? 0U : 1U);
      ++shared;
    }
  }
  EXPECT_GT(shared, 3000);
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
}  // namespace rc2::facet
