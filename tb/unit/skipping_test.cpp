// Light that can meet nothing ends early: what is left out is never missed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <vector>

#include "sw/cycle/cell.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/cycle/extents.h"
#include "tb/unit/random_packets.h"

namespace rc2::cycle {
namespace {

MachineConfig side(int n, bool skips) {
  MachineConfig config;
  config.n = n;
  config.max_distance = 4 * n;
  config.skips = skips;
  return config;
}

facet::PacketStream boxes(const std::vector<std::pair<glm::ivec3, glm::ivec3>>& corners) {
  facet::PacketStream packets;
  std::uint32_t number = 0;
  for (const auto& [low, high] : corners) add_packet(packets, number++, low, high);
  return packets;
}

/// The two machines that differ in nothing but skipping.
struct Pair {
  explicit Pair(int n) : all(side(n, false)), some(side(n, true)) {}
  void load(const facet::PacketStream& packets) {
    all.load(packets, {});
    some.load(packets, {});
  }
  CycleMachine all, some;
};

// Every voxel that a ray can still come to is looked at, one by one.
TEST(Extents, HoldAllThatIsAwayFromTheLight) {
  constexpr int kN = 7;
  Dice dice(1);
  for (int round = 0; round < 200; ++round) {
    Columns columns(kN);
    std::vector<glm::ivec3> voxels;
    for (int i = pick(dice, 0, 8); i > 0; --i) {
      voxels.push_back(pick_voxel(dice, kN));
      const glm::ivec3 at = voxels.back();
      columns.fill(cell_number(at.x, at.y, kN), at.z, {});
    }
    Extents extents(kN);
    extents.settle(columns);
    const glm::ivec3 source = pick_voxel(dice, kN);
    const std::vector<Extent> all = extents.beyond(source);
    for (int y = 0; y < kN; ++y) {
      for (int x = 0; x < kN; ++x) {
        Extent expected{kN, -1};
        for (const glm::ivec3& at : voxels) {
          const bool back_x = (at.x - x) * (x - source.x) < 0,
                     back_y = (at.y - y) * (y - source.y) < 0;
          if (back_x || back_y) continue;
          expected = {std::min(expected.min, at.z), std::max(expected.max, at.z)};
        }
        const Extent beyond = all[cell_number(x, y, kN)];
        ASSERT_EQ(beyond.none(), expected.none()) << "round " << round << " cell " << x << " " << y;
        if (expected.none()) continue;
        ASSERT_EQ(beyond.min, expected.min) << "round " << round << " cell " << x << " " << y;
        ASSERT_EQ(beyond.max, expected.max) << "round " << round << " cell " << x << " " << y;
      }
    }
  }
}

// A beam that was clipped may no longer be joined with one that was not, so a light may even take a
// few visits more.
TEST(Skipping, ChangesNoVoxel) {
  Dice dice(2);
  std::int64_t visits = 0, saved = 0;
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const int n = pick(dice, 2, 24);
    Pair machines(n);
    const glm::ivec3 source = pick_voxel(dice, n);
    facet::PacketStream scene;
    for (int i = pick(dice, 0, n * n / 2); i > 0; --i) {
      const glm::ivec3 at = pick_voxel(dice, n);
      const glm::ivec3 to =
          glm::min(at + glm::ivec3(pick(dice, 0, 1), pick(dice, 0, 1), pick(dice, 0, 3)), n - 1);
      if (source != glm::clamp(source, at, to))
        add_packet(scene, static_cast<std::uint32_t>(i), at, to);
    }
    machines.load(scene);
    const LightJob job{source, pick(dice, 1, 4 * n), pick(dice, 1, 8)};
    const LightResult all = machines.all.light(job, {}), some = machines.some.light(job, {});
    ASSERT_EQ(machines.some.read_light(), machines.all.read_light());
    EXPECT_EQ(all.targets.skipped, 0);
    EXPECT_EQ(some.targets.absorbed, all.targets.absorbed);
    EXPECT_EQ(some.targets.escaped + some.targets.skipped, all.targets.escaped);
    visits += all.visits;
    saved += all.visits - some.visits;
  }
  EXPECT_GT(saved * 10, visits);
}

TEST(Skipping, LeavesOutWhatASmallObjectDoesNotNeed) {
  constexpr int kN = 64;
  Pair machines(kN);
  machines.load(boxes({{{44, 45, 38}, {52, 53, 46}}}));
  for (const int distance : {kN - 1, 2 * kN}) {
    const LightJob job{{kN / 2, kN / 2, kN / 2}, distance, 8};
    const LightResult all = machines.all.light(job, {}), some = machines.some.light(job, {});
    EXPECT_LE(some.visits * 20, all.visits);
    EXPECT_LT(some.cycles, all.cycles);
  }
}

TEST(Skipping, NothingToLightTakesNoTime) {
  for (const int n : {2, 3, 16, 64}) {
    CycleMachine machine(side(n, true));
    const LightResult result = machine.light({glm::ivec3(n / 2), n, 8}, {});
    EXPECT_LE(result.cycles, 5);
    EXPECT_EQ(result.targets.skipped + result.targets.escaped, result.targets.total);
  }
}

// Walls all round the light; outside them another room, which it cannot reach.
TEST(Skipping, AClosedRoomCostsNothingOutsideIt) {
  constexpr int kN = 48;
  const auto room = [](int low, int high) {
    std::vector<std::pair<glm::ivec3, glm::ivec3>> walls;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int at : {low, high}) {
        glm::ivec3 from(low), to(high);
        from[axis] = to[axis] = at;
        walls.emplace_back(from, to);
      }
    }
    return walls;
  };
  auto walls = room(20, 28);
  CycleMachine alone(side(kN, true)), within(side(kN, true));
  alone.load(boxes(walls), {});
  for (const auto& wall : room(2, 45)) walls.push_back(wall);
  within.load(boxes(walls), {});
  const LightJob job{{24, 23, 25}, 2 * kN, 8};
  const LightResult one = alone.light(job, {}), two = within.light(job, {});
  EXPECT_EQ(two.targets.absorbed, two.targets.total);
  EXPECT_EQ(two.cycles, one.cycles);
  EXPECT_EQ(two.visits, one.visits);
  EXPECT_LE(two.visits, 9 * 9 * 9);
}

}  // namespace
}  // namespace rc2::cycle
