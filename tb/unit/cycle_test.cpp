#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "sw/cycle/cell.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/cycle/splitter.h"
#include "sw/golden/golden_machine.h"
#include "tb/unit/random_packets.h"

namespace rc2::cycle {
namespace {

using facet::Linear;
using facet::PacketStream;
using facet::Side;
using facet::Slab;
using golden::GoldenMachine;
using Trace = std::vector<std::vector<std::uint32_t>>;  // the queues of every cycle

glm::ivec3 pick_corner(Dice& dice, int n) { return pick_voxel(dice, 2) * (n - 1); }

MachineConfig machine_config(int n, LightMode mode = LightMode::thesis) {
  MachineConfig config;
  config.n = n;
  config.mode = mode;
  return config;
}

PacketStream dust(Dice& dice, int n, double share) {
  PacketStream stream;
  for (int i = 0; i < static_cast<int>(share * n * n * n); ++i) {
    const glm::ivec3 voxel = pick_voxel(dice, n);
    add_packet(stream, static_cast<std::uint32_t>(i), voxel, voxel);
  }
  return stream;
}

PacketStream random_scene(Dice& dice, int n) {
  const std::int64_t largest = std::int64_t{1} << (2 * (coordinate_bits(n) + 4));
  switch (pick(dice, 0, 4)) {
    case 0:
      return dust(dice, n, 0.1);
    case 1:
      return random_layers(dice, n, pick(dice, 1, 20), pick(dice, 0, 1) == 0 ? 4 : largest);
    case 2:
      return random_packets(dice, n, pick(dice, 1, 12), largest);
    default:
      return random_packets(dice, n, pick(dice, 0, 6), 4);
  }
}

bool occupied(const VoxelMemory& voxels, glm::ivec3 at) {
  return std::any_of(voxels.begin(), voxels.end(),
                     [&](const VoxelRecord& voxel) { return voxel.at == at; });
}

void expect_same_voxels(Machine& machine, Machine& golden) {
  EXPECT_TRUE(machine.read_voxels() == golden.read_voxels());
  EXPECT_TRUE(machine.read_layers() == golden.read_layers());
}

void expect_same_light(Machine& machine, Machine& golden, const LightJob& job) {
  const LightResult ours = machine.light(job, {}), theirs = golden.light(job, {});
  EXPECT_EQ(machine.read_light(), golden.read_light());
  EXPECT_EQ(ours.targets.total, theirs.targets.total);
  // What would have escaped may have been skipped, and by the accurate rule what would have ended
  // in voxels that are not there to be lit.
  if (job.rule == LightRule::thesis) {
    EXPECT_EQ(ours.targets.absorbed, theirs.targets.absorbed);
  }
  EXPECT_EQ(ours.targets.absorbed + ours.targets.escaped + ours.targets.skipped,
            theirs.targets.absorbed + theirs.targets.escaped);
  // A beam is at least one ray; the source's six are not among the voxels that rays examine.
  EXPECT_LE(ours.visits, theirs.visits + 6);
  const std::int64_t n = machine.config().n;
  if (machine.config().mode == LightMode::thesis) {
    EXPECT_EQ(ours.targets.skipped, 0);
    EXPECT_EQ(ours.merged, 0);
    EXPECT_LE(ours.max_queue, job.fa);
    // The last targets served go home from somewhere in the array.
    EXPECT_GE(ours.home_cycles, ours.cycles + 3);
  } else {
    EXPECT_LE(ours.max_queue, 2 * ((job.fa + 1) / 2) + 1);
  }
  EXPECT_LE(ours.home_cycles, ours.cycles + 4 + 2 * (n - 1));
}

// One machine goes through several loads and several lights each, so that whatever is not
// forgotten shows.
class CycleModes : public testing::TestWithParam<LightMode> {};

INSTANTIATE_TEST_SUITE_P(Modes, CycleModes, testing::Values(LightMode::fast, LightMode::thesis),
                         [](const auto& mode) { return std::string(to_string(mode.param)); });

TEST_P(CycleModes, AgreeWithGolden) {
  Dice dice(1);
  std::int64_t lights = 0, lit = 0;
  for (int n = 2; n <= 12; ++n) {
    CycleMachine machine(machine_config(n, GetParam()));
    GoldenMachine golden(machine_config(n));
    for (int round = 0; round < 25; ++round) {
      SCOPED_TRACE(testing::Message() << "n " << n << " round " << round);
      const PacketStream scene = random_scene(dice, n);
      machine.load(scene, {});
      golden.load(scene, {});
      expect_same_voxels(machine, golden);
      for (int k = 0; k < 3; ++k) {
        const LightJob job{k == 0 ? pick_corner(dice, n) : pick_voxel(dice, n),
                           pick(dice, 1, 4 * n), k == 1 ? pick(dice, 1, 3) : pick(dice, 1, 32)};
        if (occupied(golden.read_voxels(), job.source)) continue;
        expect_same_light(machine, golden, job);
        ++lights;
        for (const std::uint32_t count : machine.read_light()) lit += count > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(lights, 300);
  EXPECT_GT(lit, 5000);
}

TEST(CycleMachine, ForgetsTheLightWhenItLoads) {
  Dice dice(2);
  CycleMachine machine(machine_config(6));
  const PacketStream scene = dust(dice, 6, 0.3);
  machine.load(scene, {});
  const LightMemory dark(machine.read_voxels().size(), 0);
  EXPECT_EQ(machine.read_light(), dark);
  const auto is_free = [&](glm::ivec3 at) { return !occupied(machine.read_voxels(), at); };
  glm::ivec3 source = pick_voxel(dice, 6);
  while (!is_free(source)) source = pick_voxel(dice, 6);
  machine.light({source, 5, 4}, {});
  EXPECT_NE(machine.read_light(), dark);
  machine.load(scene, {});
  EXPECT_EQ(machine.read_light(), dark);
}

TEST(CycleMachine, RefusesWhatDoesNotFit) {
  CycleMachine machine(machine_config(4));
  PacketStream scene;
  add_packet(scene, 7, {1, 2, 3}, {1, 2, 3});
  machine.load(scene, {});
  const LightJob occupied_source{{1, 2, 3}, 3, 1}, outside{{0, 4, 0}, 3, 1}, far{{0, 0, 0}, 65, 1},
      deep{{0, 0, 0}, 3, 33};
  for (const LightJob& job : {occupied_source, outside, far, deep}) {
    EXPECT_THROW(machine.light(job, {}), Error);
  }

  // In range where it starts, out of range at the far end of its box.
  const std::int64_t offset = std::int64_t{1} << (offset_bits(4, 4) - 1);
  PacketStream grows, shrinks;
  add_packet(grows, 0, {0, 0, 0}, {3, 0, 0}, {},
             {{{1, 0, 0, offset - 4}, 0}, {{1, 0, 0, offset - 3}, 0}});
  add_packet(shrinks, 0, {0, 0, 0}, {0, 3, 0}, {},
             {{{0, -1, 0, 3 - offset}, 0}, {{0, -1, 0, 2 - offset}, 0}});
  EXPECT_THROW(machine.load(grows, {}), Error);
  EXPECT_THROW(machine.load(shrinks, {}), Error);
  EXPECT_EQ(machine.read_voxels().size(), 1U);
  grows.sides[1].value.d = shrinks.sides[1].value.d = 0;
  EXPECT_NO_THROW(machine.load(grows, {}));
  EXPECT_NO_THROW(machine.load(shrinks, {}));

  EXPECT_THROW(CycleMachine(machine_config(1)), Error);
}

TEST(CycleMachine, ReportsProgress) {
  Dice dice(3);
  MachineConfig config = machine_config(24);
  config.max_distance = 400;
  CycleMachine machine(config);
  std::map<std::string, double> shares;
  const auto progress = [&](const char* step, std::int64_t, double share) {
    EXPECT_GE(share, shares[step]);
    EXPECT_LE(share, 1);
    shares[step] = share;
  };
  machine.load(random_packets(dice, 24, 800, 4), progress);
  machine.load({}, {});
  machine.light({{0, 0, 0}, 400, 1}, progress);
  EXPECT_GT(shares["load"], 0);
  EXPECT_GT(shares["light"], 0);
}

// ---- Loading
// --------------------------------------------------------------------------------------

// One packet for the m voxels above z = 1 of one column, with sides c*z + d >= 0.
std::int64_t cycles_of_one_column(glm::ivec3 cell, int m, int sides, std::int64_t c,
                                  std::int64_t d) {
  CycleMachine machine(machine_config(16));
  PacketStream stream;
  add_packet(stream, 0, {cell.x, cell.y, 1}, {cell.x, cell.y, m}, {},
             std::vector<Side>(static_cast<std::size_t>(sides), {{0, 0, c, d}, 0}));
  return machine.load(stream, {}).cycles;
}

// HEAD spends a cycle in the feeder of its row and one in its cell; the other words follow; then
// one cycle per voxel and one for the last write.
TEST(CycleLoad, TakesTheCyclesOfItsPipe) {
  for (const glm::ivec3 cell : {glm::ivec3(0), {3, 0, 0}, {0, 5, 0}, {15, 15, 0}}) {
    for (const int m : {1, 2, 7, 15}) {
      for (const int sides : {0, 3}) {
        const int way = 5 + cell.x + cell.y;
        EXPECT_EQ(cycles_of_one_column(cell, m, sides, 0, 0), way + sides + m);
        // A bound that must be divided waits one cycle more for each bit of the range.
        EXPECT_EQ(cycles_of_one_column(cell, m, sides, 3, 0), way + sides * (1 + bits_for(m)) + m);
        // The gap at the dexel's low end takes one cycle for each bit of its z.
        if (sides > 0) {
          EXPECT_EQ(cycles_of_one_column(cell, m, sides, 1, 1 - m),
                    way + sides * (1 + bits_for(m)) + bits_for(m) + 1);
        }
      }
    }
  }
}

// Packets for different cells overlap in time: the host's port is the limit, and with more feeders
// the busiest of them.
TEST(CycleLoad, TakesOneWordPerFeederAndCycle) {
  const int n = 16;
  PacketStream stream;
  for (int i = 0; i < 1000; ++i) {
    const glm::ivec3 voxel(i * 7 % n, i * 5 % n, i * 3 % n);
    add_packet(stream, static_cast<std::uint32_t>(i), voxel, voxel);
  }
  for (const int feeders : {1, 2, 8, 16}) {
    MachineConfig config = machine_config(n);
    config.feeders = feeders;
    std::int64_t busiest = 0;
    for (int k = 0; k < feeders; ++k) {
      const auto mine = std::count_if(stream.heads.begin(), stream.heads.end(),
                                      [&](const auto& head) { return head.lo.y % feeders == k; });
      busiest = std::max<std::int64_t>(busiest, 3 * mine);
    }
    const std::int64_t cycles = CycleMachine(config).load(stream, {}).cycles;
    EXPECT_GE(cycles, busiest);
    EXPECT_LE(cycles, busiest + std::int64_t{2} * n + 8);
  }
}

TEST(CycleLoad, CostsNothingWithoutPackets) {
  CycleMachine machine(machine_config(5));
  EXPECT_EQ(machine.load({}, {}).cycles, 0);
}

TEST(CycleColumns, KeepTheBestClaimAndEveryTarget) {
  Dice dice(4);
  const int n = 130;
  Columns columns(n);
  std::map<int, std::pair<std::uint32_t, std::uint32_t>> expected;
  const std::size_t column = 17;
  for (int i = 0; i < 300; ++i) {
    const int z = pick(dice, 0, n - 1);
    const Claim claim{static_cast<std::uint32_t>(pick(dice, 0, 1000)), pick(dice, 0, 1) == 0,
                      pick(dice, -3, 3)};
    columns.fill(column, z, {claim});
    const auto [voxel, first] = expected.try_emplace(z, claim.packed(), 0);
    if (!first) voxel->second.first = std::min(voxel->second.first, claim.packed());
  }
  for (auto& [z, voxel] : expected) {
    for (int k = pick(dice, 0, 3); k > 0; --k) {
      const int targets = pick(dice, 1, 100);
      columns.light(column, z, targets);
      voxel.second += static_cast<std::uint32_t>(targets);
    }
  }
  for (int z = 0; z < n; ++z) {
    const auto voxel = expected.find(z);
    ASSERT_EQ(columns.occupied(column, z), voxel != expected.end());
    EXPECT_FALSE(columns.occupied(column - 1, z));
    EXPECT_FALSE(columns.occupied(column + 1, z));
    if (voxel == expected.end()) continue;
    EXPECT_EQ(columns.owner(column, z).claim.packed(), voxel->second.first);
    EXPECT_EQ(columns.arrived(column, z), voxel->second.second);
  }
}

// ---- Light
// ----------------------------------------------------------------------------------------

TEST(CycleYmed, IsTheExactQuotientDownAndUp) {
  for (int step = 1; step <= 40; ++step) {
    for (int offset = 0; offset < step; ++offset) {
      for (const int distance : {1, 2, 3, 7, 64, 1000, 32767}) {
        const Ymed y = ymed(offset, step, distance);
        const int product = (2 * offset + 1) * distance, divisor = 2 * step;
        EXPECT_LE(y.floor * divisor, product);
        EXPECT_GT((y.floor + 1) * divisor, product);
        EXPECT_GE(y.ceil * divisor, product);
        EXPECT_LT((y.ceil - 1) * divisor, product);
      }
    }
  }
}

// The integer nearest to j*k/L, ties downwards: ceil(j*k/L - 1/2).
int ray_offset(int target, int step, int distance) {
  const int numerator = 2 * target * step - distance, denominator = 2 * distance;
  const int quotient = numerator / denominator;
  return quotient + (numerator > 0 && numerator % denominator != 0 ? 1 : 0);
}

// Each target of a beam is in the part that goes where its ray goes, and in no other.
TEST(CycleSplitAxis, FollowsEachRay) {
  for (int distance = 1; distance <= 9; ++distance) {
    for (int step = 0; step <= 12; ++step) {
      for (int offset = -step; offset <= step; ++offset) {
        std::vector<int> targets;
        for (int j = -distance; j <= distance; ++j) {
          if (ray_offset(j, step, distance) == offset) targets.push_back(j);
        }
        for (std::size_t i = 0; i < targets.size(); ++i) {
          for (std::size_t k = i; k < targets.size(); ++k) {
            const Parts parts =
                split_axis(range(targets[i], targets[k]), offset, step + 1, distance);
            for (int j = targets[i]; j <= targets[k]; ++j) {
              for (const Place place : {kLow, kMiddle, kHigh}) {
                const Range part = parts.part[place];
                const bool present = (parts.present >> place & 1U) != 0;
                EXPECT_EQ(present && part.min <= j && j <= part.max,
                          ray_offset(j, step + 1, distance) == offset + cells_on(place));
              }
            }
          }
        }
      }
    }
  }
}

TEST(CycleRotate, LetsNobodyWaitForMoreThanEveryOtherOnce) {
  Dice dice(7);
  Rotate rotate;
  std::array<int, 9> waited{};  // grants to others while a way kept asking
  unsigned requests = 0;
  for (int round = 0; round < 5000; ++round) {
    requests |= 1U << pick(dice, 0, 8) | 1U << pick(dice, 0, 8);
    const unsigned granted = rotate.take(requests);
    ASSERT_NE(requests >> granted & 1U, 0U);
    for (unsigned way = 0; way < waited.size(); ++way) {
      if ((requests >> way & 1U) == 0 || way == granted) continue;
      ASSERT_LE(++waited[way], 8);
    }
    waited[granted] = 0;
    if (pick(dice, 0, 1) == 0) requests &= ~(1U << granted);
  }
}

// One cycle per column and row on the way to the corner, and four for the sums.
TEST(CycleTally, WaitsForTheFarthest) {
  Tally tally;
  tally.finish(10, 3, 5, 7);
  EXPECT_EQ(tally.home_cycle(), 22);
  tally.finish(11, 2, 4, 1);
  EXPECT_EQ(tally.home_cycle(), 22);
  tally.finish(12, 9, 9, 0);
  EXPECT_EQ(tally.home_cycle(), 22);
  tally.finish(13, 9, 9, 2);
  EXPECT_EQ(tally.home_cycle(), 35);
  EXPECT_EQ(tally.home(), 10);
}

// A hop takes three cycles, and the farthest cell is kmax hops away (thesis 4.4.3). Every voxel
// sees a beam once the faces are at L >= n-1 (thesis 4.1.4), the source its six.
TEST(CycleLight, CrossesTheEmptyCube) {
  for (const int n : {2, 3, 5, 8, 13, 16}) {
    for (const glm::ivec3 source :
         {glm::ivec3(n / 2), {0, 0, 0}, {n - 1, 0, n - 1}, {0, n / 2, 0}}) {
      for (const int fa : {1, 4, 32}) {
        CycleMachine machine(machine_config(n));
        const LightResult result = machine.light({source, n - 1, fa}, {});
        const int kmax = std::max({source.x, source.y, n - 1 - source.x, n - 1 - source.y});
        EXPECT_GE(result.cycles, 3 * kmax);
        EXPECT_GE(result.visits, n * n * n + 5);
        EXPECT_EQ(result.targets.escaped, result.targets.total);
      }
    }
  }
}

// The beam straight to the east enters its first queue in cycle 2 and leaves in cycle 3, after the
// part that goes down; from then on nothing is in its way.
TEST(CycleLight, TakesThreeCyclesPerHop) {
  const int n = 16;
  CycleMachine machine(machine_config(n));
  std::vector<std::int64_t> first(n, 0);  // cycle in which the queue of (x,0) has its first beam
  machine.observe([&](std::int64_t cycle, const std::vector<std::uint32_t>& queues) {
    for (std::size_t x = 0; x < n; ++x) {
      if (first[x] == 0 && queues[x] != 0) first[x] = cycle;
    }
  });
  machine.light({{0, 0, 0}, 1, 32}, {});
  EXPECT_EQ(first[0], 2);
  for (std::size_t x = 1; x < n; ++x) EXPECT_EQ(first[x], 3 + 3 * static_cast<std::int64_t>(x));
}

TEST(CycleLight, NeverHangsHoweverShortTheQueue) {
  Dice dice(5);
  for (int round = 0; round < 40; ++round) {
    const int n = pick(dice, 2, 16);
    CycleMachine machine(machine_config(n));
    EXPECT_NO_THROW(machine.light({pick_voxel(dice, n), pick(dice, 1, 64), 1}, {}));
  }
}

TEST(CycleLight, ShowsEveryCycleToTheObserver) {
  CycleMachine machine(machine_config(9));
  std::int64_t cycles = 0, deepest = 0;
  machine.observe([&](std::int64_t cycle, const std::vector<std::uint32_t>& queues) {
    EXPECT_EQ(cycle, ++cycles);
    ASSERT_EQ(queues.size(), 81U);
    deepest = std::max<std::int64_t>(deepest, *std::max_element(queues.begin(), queues.end()));
  });
  const LightResult result = machine.light({{2, 3, 4}, 20, 7}, {});
  EXPECT_EQ(cycles, result.cycles - 1);  // the last is the tally's
  EXPECT_EQ(deepest, result.max_queue);
  EXPECT_EQ(deepest, 7);
}

// All cells in each cycle, at rest or not, each phase in an order of its own.
Trace run_in_any_order(Dice& dice, int n, Columns& columns, const LightJob& job) {
  Router router(n);
  Diffuser diffuser(n, columns, router);
  router.start(job);
  diffuser.start(job);
  std::vector<std::size_t> cells(columns.size());
  std::iota(cells.begin(), cells.end(), 0);
  const auto busy = [&](std::size_t cell) { return router.busy(cell) || diffuser.busy(cell); };
  Trace trace;
  while (std::any_of(cells.begin(), cells.end(), busy)) {
    trace.push_back(diffuser.queues());
    dice.shuffle(cells.begin(), cells.end());
    for (const std::size_t cell : cells) router.move_links(cell, [](std::size_t) {});
    dice.shuffle(cells.begin(), cells.end());
    for (const std::size_t cell : cells) {
      diffuser.step(cell, static_cast<std::int64_t>(trace.size()));
      router.merge(cell);
    }
  }
  return trace;
}

TEST(CycleLight, DoesNotDependOnTheOrderOfCells) {
  Dice dice(6);
  for (int round = 0; round < 20; ++round) {
    const int n = pick(dice, 2, 10);
    const LightJob job{pick_voxel(dice, n), pick(dice, 1, 2 * n), pick(dice, 1, 6)};
    Columns columns(n);
    for (int i = 0; i < n * n * n / 10; ++i) {
      const glm::ivec3 at = pick_voxel(dice, n);
      if (at != job.source) columns.fill(cell_number(at.x, at.y, n), at.z, {});
    }
    const Trace shuffled = run_in_any_order(dice, n, columns, job);
    Trace trace;
    LightArray array(n, columns);
    array.run(job, [&](std::int64_t, const auto& queues) { trace.push_back(queues); }, {});
    EXPECT_EQ(trace, shuffled) << "round " << round;
  }
}

}  // namespace
}  // namespace rc2::cycle
