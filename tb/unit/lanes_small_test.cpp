// Light in lanes on the smallest machines, all of them: nothing is lost, nobody waits for ever.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <glm/common.hpp>
#include <set>

#include "sw/cycle/cell.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/cycle/lane_array.h"
#include "sw/golden/golden_machine.h"
#include "tb/unit/random_packets.h"

namespace rc2::cycle {
namespace {

MachineConfig smallest(int n) {
  MachineConfig config;
  config.n = n;
  return config;
}

glm::ivec3 voxel_at(int number, int n) { return {number % n, number / n % n, number / (n * n)}; }

// Bit i of the set says that voxel i is occupied.
facet::PacketStream packets_of(std::uint64_t set, int n) {
  facet::PacketStream packets;
  for (int i = 0; i < n * n * n; ++i) {
    if ((set >> i & 1) == 0) continue;
    const glm::ivec3 at = voxel_at(i, n);
    add_packet(packets, static_cast<std::uint32_t>(i), at, at);
  }
  return packets;
}

int distance_of(std::size_t cell, const glm::ivec3& source, int n) {
  const auto number = static_cast<int>(cell);
  return std::max(std::abs(number % n - source.x), std::abs(number / n - source.y));
}

// Who waits waits for the cells that it sends to. All of them are one step farther from the light,
// so no cell waits for itself, by whatever detour.
TEST(SmallLanes, SideBeamsOnlyWaitOutwards) {
  for (int n = 2; n <= 4; ++n) {
    Columns empty(n);
    const Extent all{0, n - 1};
    const std::vector<Outlook> anything(empty.size(), {all, all, 0});
    SideLane lane(n, empty);
    for (int number = 0; number < n * n * n; ++number) {
      const glm::ivec3 source = voxel_at(number, n);
      std::set<std::pair<std::size_t, std::size_t>> waits;
      for (int distance = 1; distance <= 4 * n; ++distance) {
        const Classes classes(distance, farthest_face(source, n) + 1);
        lane.start({source, distance, 1}, classes, anything);
        for (std::int64_t cycle = 1; lane.busy(); ++cycle) {
          ASSERT_LT(cycle, 1000) << "n " << n << " source " << number << " L " << distance;
          lane.step(cycle);
          lane.for_each_sent([&](std::size_t from, std::size_t to) { waits.emplace(from, to); });
        }
      }
      for (const auto& [from, to] : waits) {
        ASSERT_EQ(distance_of(to, source, n), distance_of(from, source, n) + 1)
            << "n " << n << " source " << number << ": " << from << " to " << to;
      }
      // Every cell but the source's is sent something: nothing has been looked at in vain.
      std::set<std::size_t> reached;
      for (const auto& [from, to] : waits) reached.insert(to);
      ASSERT_EQ(reached.size(), static_cast<std::size_t>(n * n - 1));
    }
  }
}

class Pair {
 public:
  explicit Pair(int n) : fast_(smallest(n)), golden_(smallest(n)) {}

  void load(const facet::PacketStream& scene) {
    fast_.load(scene, {});
    golden_.load(scene, {});
  }

  bool is_occupied(const glm::ivec3& at) {
    const VoxelMemory voxels = golden_.read_voxels();
    return std::any_of(voxels.begin(), voxels.end(),
                       [&](const VoxelRecord& voxel) { return voxel.at == at; });
  }

  // The fast machine throws if it hangs or loses a target.
  void expect_same_light(const LightJob& job) {
    const LightResult ours = fast_.light(job, {});
    const LightResult wanted = golden_.light(job, {});
    ASSERT_EQ(fast_.read_light(), golden_.read_light());
    // By the accurate rule light that can light nothing more is skipped before it ends in a voxel.
    if (job.rule == LightRule::thesis) {
      ASSERT_EQ(ours.targets.absorbed, wanted.targets.absorbed);
    }
    ASSERT_LE(ours.targets.absorbed, wanted.targets.absorbed);
    ASSERT_LE(ours.max_queue, 2 * ((job.fa + 1) / 2) + 1);
  }

 private:
  CycleMachine fast_;
  golden::GoldenMachine golden_;
};

TEST(SmallLanes, EveryCubeOfTwoVoxels) {
  Pair machines(2);
  int lights = 0;
  for (unsigned set = 0; set < 256; ++set) {
    machines.load(packets_of(set, 2));
    for (int number = 0; number < 8; ++number) {
      if ((set >> number & 1) != 0) continue;
      for (int distance = 1; distance <= 8; ++distance, ++lights) {
        SCOPED_TRACE(testing::Message()
                     << "voxels " << set << " source " << number << " L " << distance);
        machines.expect_same_light({voxel_at(number, 2), distance, 1});
        if (HasFatalFailure()) return;
      }
    }
  }
  EXPECT_EQ(lights, 8 * 128 * 8);
}

// All shares of occupied voxels, most of them low, where light gets far.
TEST(SmallLanes, RandomCubesOfThreeAndFourVoxels) {
  for (const int n : {3, 4}) {
    Dice dice(static_cast<std::uint64_t>(n));
    Pair machines(n);
    for (int round = 0; round < 10'000; ++round) {
      const int sparsity = pick(dice, 1, 20);
      std::uint64_t set = 0;
      for (int i = 0; i < n * n * n; ++i) {
        if (pick(dice, 0, sparsity) == 0) set |= std::uint64_t{1} << i;
      }
      const int number = pick(dice, 0, n * n * n - 1);
      set &= ~(std::uint64_t{1} << number);
      const LightJob job{voxel_at(number, n), pick(dice, 1, 4 * n), pick(dice, 1, 4)};
      SCOPED_TRACE(testing::Message() << "n " << n << " voxels " << set << " source " << number
                                      << " L " << job.target_distance << " FA " << job.fa);
      machines.load(packets_of(set, n));
      machines.expect_same_light(job);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SmallLanes, RandomLayersByTheAccurateRule) {
  std::size_t lights = 0;
  for (const int n : {2, 3, 4}) {
    Dice dice(static_cast<std::uint64_t>(n));
    Pair machines(n);
    for (int round = 0; round < 4'000; ++round) {
      const facet::PacketStream scene = random_layers(dice, n, pick(dice, 1, 12), 4);
      machines.load(scene);
      const glm::ivec3 source = pick_voxel(dice, n);
      if (machines.is_occupied(source)) continue;
      SCOPED_TRACE(testing::Message() << "n " << n << " round " << round);
      machines.expect_same_light(
          {source, pick(dice, 1, 4 * n), pick(dice, 1, 4), LightRule::accurate});
      if (HasFatalFailure()) return;
      ++lights;
    }
  }
  EXPECT_GT(lights, 6'000U);
}

}  // namespace
}  // namespace rc2::cycle
