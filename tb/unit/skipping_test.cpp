// Light that can meet nothing ends early: what is left out is never missed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

// Every ray of a light, voxel by voxel, rounded both ways where it is half between two: up to the
// last voxel that it meets no layer that it is in may count for nothing.
TEST(Extents, HoldEveryWayToAnOccupiedVoxel) {
  Dice dice(1);
  int missable = 0;
  for (int round = 0; round < 80; ++round) {
    const int n = pick(dice, 2, 12), distance = pick(dice, 1, 2 * n);
    Columns columns(n);
    for (int i = pick(dice, 1, 6); i > 0; --i) {
      const glm::ivec3 at = pick_voxel(dice, n);
      columns.fill(cell_number(at.x, at.y, n), at.z, {});
    }
    Extents extents(n);
    extents.settle(columns);
    const glm::ivec3 source = pick_voxel(dice, n);
    const std::vector<Outlook> outlooks = extents.seen_from(source);
    const auto follow = [&](const glm::ivec3& target, int half) {
      std::vector<glm::ivec3> way;
      std::size_t met = 0;
      for (int k = 0;; ++k) {
        glm::ivec3 at = source;
        for (int axis = 0; axis < 3; ++axis) {
          const double exact = static_cast<double>(k) * target[axis] / distance;
          at[axis] += static_cast<int>(half > 0 ? std::floor(exact + 0.5) : std::ceil(exact - 0.5));
        }
        if (glm::clamp(at, 0, n - 1) != at) break;
        way.push_back(at);
        if (columns.occupied(cell_number(at.x, at.y, n), at.z)) met = way.size();
      }
      for (std::size_t k = 0; k < met; ++k) {
        const Outlook& outlook = outlooks[cell_number(way[k].x, way[k].y, n)];
        ASSERT_FALSE(outlook.at_first.none()) << "round " << round;
        ASSERT_LE(outlook.later.min, way[k].z) << "round " << round << " step " << k;
        ASSERT_GE(outlook.later.max, way[k].z) << "round " << round << " step " << k;
        if (outlook.later.min > 0 || outlook.later.max < n - 1) ++missable;
      }
    };
    for (int a = -distance; a <= distance; ++a) {
      for (int b = -distance; b <= distance; ++b) {
        for (const int face : {-distance, distance}) {
          for (const int half : {-1, 1}) {
            follow({face, a, b}, half);
            follow({a, face, b}, half);
            follow({a, b, face}, half);
          }
        }
      }
    }
  }
  EXPECT_GT(missable, 1000);
}

// From the corner a single quadrant has the whole scene in it.
TEST(Extents, TellDirectionsApart) {
  constexpr int kN = 64;
  Pair machines(kN);
  machines.load(boxes({{{28, 28, 28}, {35, 35, 35}}}));
  const LightJob job{{0, 0, 0}, kN - 1, 8};
  EXPECT_LE(machines.some.light(job, {}).visits * 20, machines.all.light(job, {}).visits);
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
