// Light in lanes: its parts against one ray after the other, and how long it takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sw/cycle/cell.h"
#include "sw/cycle/classes.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/cycle/lane_array.h"
#include "sw/cycle/stop_table.h"
#include "sw/lines/digital_line.h"
#include "tb/unit/random_packets.h"

namespace rc2::cycle {
namespace {

// Where each target's ray is after 0, 1, .. `steps` steps.
using Path = std::vector<int>;

std::map<int, Path> follow_rays(int distance, int steps) {
  std::map<int, Path> paths;
  for (int target = 1 - distance; target < distance; ++target) {
    lines::DigitalLine line(target, distance);
    Path& path = paths[target];
    path.push_back(0);
    for (int step = 0; step < steps; ++step) path.push_back(path.back() + line.advance());
  }
  return paths;
}

Path start_of(const Path& path, int step) { return {path.begin(), path.begin() + step + 1}; }

// The classes of a list as targets, innermost first: those whose rays have gone the same way.
std::vector<std::vector<int>> same_ways(const std::map<int, Path>& paths, int step, int offset) {
  std::map<Path, std::vector<int>> ways;
  for (const auto& [target, path] : paths) {
    if (path[static_cast<std::size_t>(step)] == offset)
      ways[start_of(path, step)].push_back(target);
  }
  std::vector<std::vector<int>> classes;
  classes.reserve(ways.size());
  for (const auto& [path, targets] : ways) classes.push_back(targets);
  std::sort(classes.begin(), classes.end(),
            [](const auto& a, const auto& b) { return std::abs(a.front()) < std::abs(b.front()); });
  return classes;
}

TEST(Classes, AreTheTargetsThatHaveGoneTheSameWay) {
  constexpr int kSteps = 14;
  for (const int distance : {1, 2, 3, 4, 7, 12, 15, 18, 30, 54, 55}) {
    const auto paths = follow_rays(distance, kSteps + 1);
    const Classes classes(distance, kSteps);
    for (int step = 0; step <= kSteps; ++step) {
      for (int offset = -step; offset <= step; ++offset) {
        SCOPED_TRACE(testing::Message()
                     << "L " << distance << " step " << step << " offset " << offset);
        const auto ways = same_ways(paths, step, offset);
        const Classes::Cut& cut = classes.cut(step, offset);
        ASSERT_EQ(cut.count, ways.size());
        bool down = false, up = false;
        for (std::size_t i = 0; i < ways.size(); ++i) {
          ASSERT_EQ(classes.targets(step, offset, ClassSet{1} << i),
                    static_cast<std::int64_t>(ways[i].size()));
          bool stays = false, leaves = false;
          for (const int target : ways[i]) {
            const int next = paths.at(target)[static_cast<std::size_t>(step) + 1];
            (next == offset ? stays : leaves) = true;
            down = down || next < offset;
            up = up || next > offset;
          }
          ASSERT_EQ(stays, i < cut.stay);
          ASSERT_EQ(leaves, i >= cut.leave);
        }
        if (offset == 0) {
          ASSERT_EQ(cut.down, down);
          ASSERT_EQ(cut.up, up);
        } else {
          ASSERT_EQ(cut.down, offset < 0);
          ASSERT_EQ(cut.up, offset > 0);
        }
        if (step == 0) continue;
        std::size_t came = 0;
        for (const auto& way : ways) {
          if (paths.at(way.front())[static_cast<std::size_t>(step) - 1] != offset) ++came;
        }
        ASSERT_EQ(cut.come, came);
      }
    }
  }
}

TEST(Slope, IsWhereRaysAre) {
  for (const int distance : {1, 2, 5, 16, 31, 64}) {
    for (int step = 1; step <= 20; ++step) {
      const Slope slope{step, distance};
      std::map<int, int> lowest;
      for (int target = -distance; target <= distance; ++target) {
        lines::DigitalLine line(target, distance);
        int offset = 0;
        for (int i = 0; i < step; ++i) offset += line.advance();
        ASSERT_EQ(slope.offset(target), offset);
        for (int z = -step - 2; z <= offset; ++z) lowest.try_emplace(z, target);
      }
      for (int z = -step - 2; z <= step + 2; ++z) {
        const auto found = lowest.find(z);
        ASSERT_EQ(slope.lowest(z), found == lowest.end() ? distance + 1 : found->second);
      }
    }
  }
}

// A beam that asks again and again learns of each target once, and the truth.
TEST(StopTable, SaysWhatBecomesOfEachTarget) {
  Dice dice(11);
  for (int round = 0; round < 3000; ++round) {
    const int n = pick(dice, 2, 40);
    const Slope slope{pick(dice, 1, n - 1), pick(dice, 1, 3 * n)};
    const int source_z = pick(dice, 0, n - 1);
    Columns columns(n);
    const int share = pick(dice, 1, 9);
    for (int z = 0; z < n; ++z) {
      if (pick(dice, 0, share) == 0) columns.fill(0, z, {});
    }
    columns.darken();
    const int first = std::max(0, source_z - slope.step);
    const int last = std::min(n - 1, source_z + slope.step);
    const Targets clip = slope.between(first - source_z, last - source_z);
    if (clip.none()) continue;
    Targets beam{pick(dice, clip.min, clip.max), 0};
    beam.max = pick(dice, beam.min, clip.max);

    StopTable table;
    table.fill(columns, 0, slope, source_z, first, last, 0);
    std::vector<int> passed, expected;
    for (int target = beam.min; target <= beam.max; ++target) {
      if (!columns.occupied(0, source_z + slope.offset(target))) expected.push_back(target);
    }
    while (!beam.none()) {
      if (!table.knows(beam.min)) {
        table.fill(columns, 0, slope, source_z, source_z + slope.offset(beam.min), last, 0);
      }
      ASSERT_TRUE(table.knows(beam.min)) << "round " << round;
      const StopTable::Passage passage = table.pass(beam);
      ASSERT_GE(passage.end, beam.min);
      ASSERT_LE(passage.end, beam.max);
      for (int target = passage.free.min; target <= passage.free.max; ++target) {
        passed.push_back(target);
      }
      beam.min = passage.end + 1;
    }
    ASSERT_EQ(passed, expected) << "round " << round;
  }
}

MachineConfig fast(int n) {
  MachineConfig config;
  config.n = n;
  config.max_distance = 4 * n;
  return config;
}

// The empty cube, any source: two cycles a step to the farthest face, one less if the last step is
// up a z lane, and at most eight more.
TEST(Lanes, CrossTheEmptyCubeInTwoCyclesAStep) {
  Dice dice(12);
  for (const int n : {2, 3, 5, 16, 33, 64}) {
    MachineConfig config = fast(n);
    config.skips = false;
    CycleMachine machine(config);
    for (int round = 0; round < 12; ++round) {
      glm::ivec3 source = pick_voxel(dice, n);
      if (round < 4) source = pick_voxel(dice, 2) * (n - 1);
      if (round == 4) source = glm::ivec3(n / 2);
      const int kmax = farthest_face(source, n);
      for (const int distance : {std::max(1, n - 1), 2 * n}) {
        for (const int fa : {1, 4, 8}) {
          const LightResult result = machine.light({source, distance, fa}, {});
          EXPECT_GE(result.cycles, 2 * kmax + 1);
          if (fa > 1) {
            EXPECT_LE(result.cycles, 2 * (kmax + 1) + 8) << "n " << n << " fa " << fa;
          }
          EXPECT_EQ(result.targets.escaped, result.targets.total);
        }
      }
    }
  }
}

TEST(Lanes, NeverHangHoweverShortTheQueue) {
  Dice dice(13);
  for (int round = 0; round < 60; ++round) {
    const int n = pick(dice, 2, 16);
    CycleMachine machine(fast(n));
    const glm::ivec3 source = pick_voxel(dice, n);
    facet::PacketStream scene;
    for (int i = 0; i < n * n * n / 8; ++i) {
      const glm::ivec3 at = pick_voxel(dice, n);
      if (at != source) add_packet(scene, static_cast<std::uint32_t>(i), at, at);
    }
    machine.load(scene, {});
    EXPECT_NO_THROW(machine.light({source, pick(dice, 1, 4 * n), 1}, {}));
  }
}

// Queues in every cycle, cell by cell.
TEST(Lanes, ShowEveryCycleToTheObserver) {
  MachineConfig config = fast(9);
  config.skips = false;
  CycleMachine machine(config);
  std::int64_t cycles = 0, deepest = 0;
  machine.observe([&](std::int64_t cycle, const std::vector<std::uint32_t>& queues) {
    EXPECT_EQ(cycle, ++cycles);
    ASSERT_EQ(queues.size(), 81U);
    deepest = std::max<std::int64_t>(deepest, *std::max_element(queues.begin(), queues.end()));
  });
  const LightResult result = machine.light({{2, 3, 4}, 20, 7}, {});
  EXPECT_LE(cycles, result.cycles);
  EXPECT_EQ(deepest, result.max_queue);
}

}  // namespace
}  // namespace rc2::cycle
