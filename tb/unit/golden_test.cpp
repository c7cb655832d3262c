#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/rational.hpp>
#include <glm/common.hpp>
#include <limits>
#include <map>
#include <random>
#include <tuple>

#include "sw/golden/golden_machine.h"

namespace rc2::golden {
namespace {

using boost::multiprecision::cpp_int;
using Rational = boost::rational<std::int64_t>;
using facet::Linear;
using facet::PacketStream;
using facet::Side;
using facet::Slab;
using Voxel = std::tuple<int, int, int>;

Voxel key(glm::ivec3 at) { return {at.x, at.y, at.z}; }

MachineConfig machine_config(int n, int max_distance = 64) {
  MachineConfig config;
  config.n = n;
  config.max_distance = max_distance;
  return config;
}

void add_packet(PacketStream& stream, std::uint32_t number, glm::ivec3 lo, glm::ivec3 hi,
                const Slab& slab = {}, const std::vector<Side>& sides = {},
                const Linear& gap = {}) {
  stream.heads.push_back({number, lo, hi, slab, gap,
                          static_cast<std::uint32_t>(stream.sides.size()),
                          static_cast<std::uint32_t>(sides.size())});
  stream.sides.insert(stream.sides.end(), sides.begin(), sides.end());
}

using Random = std::mt19937;

int pick(Random& random, int lowest, int highest) {
  return std::uniform_int_distribution<int>(lowest, highest)(random);
}

glm::ivec3 pick_voxel(Random& random, int n) {
  return {pick(random, 0, n - 1), pick(random, 0, n - 1), pick(random, 0, n - 1)};
}

// Boxes cut by a slab and a few sides; `scale` is the size of the coefficients.
PacketStream random_packets(Random& random, int n, int count, std::int64_t scale) {
  const auto linear = [&](std::int64_t largest) {
    std::uniform_int_distribution<std::int64_t> coefficient(-largest, largest);
    Linear value{coefficient(random), coefficient(random), coefficient(random),
                 n * coefficient(random) / 2};
    if (pick(random, 0, 3) == 0) value.c = 0;
    return value;
  };
  const std::int64_t side_scale = std::min(scale, std::int64_t{1} << (coordinate_bits(n) + 4));
  PacketStream stream;
  for (int i = 0; i < count; ++i) {
    const glm::ivec3 a = pick_voxel(random, n), b = pick_voxel(random, n);
    const Slab slab{linear(scale),
                    std::uniform_int_distribution<std::int64_t>(0, 3 * scale)(random)};
    std::vector<Side> sides;
    for (int k = pick(random, 0, 4); k > 0; --k)
      sides.push_back(
          {linear(side_scale), std::uniform_int_distribution<std::int64_t>(0, side_scale)(random)});
    const std::int64_t steepest = std::int64_t{1} << gap_fraction_bits(n);
    add_packet(stream, static_cast<std::uint32_t>(i), glm::min(a, b), glm::max(a, b), slab, sides,
               linear(pick(random, 0, 2) == 0 ? 3 : steepest));
  }
  return stream;
}

// Core first, then the nearest plane, then the lowest number. Gaps of the same size in front of and
// behind a plane are -1 and 0, -2 and 1, ...
using Rank = std::tuple<bool, int, std::uint32_t>;
Rank rank(const Claim& claim) {
  return {!claim.core, std::max(claim.gap, -1 - claim.gap), claim.facet};
}

// Sixteenths, rounded down, of which only what lies within two voxels is kept.
int brute_force_gap(const cpp_int& value, int n) {
  const cpp_int unit = cpp_int(1) << (coordinate_bits(n) + 2);
  cpp_int sixteenths = value / unit;
  if (sixteenths * unit > value) --sixteenths;
  while (sixteenths >= 32) sixteenths -= 64;
  while (sixteenths < -32) sixteenths += 64;
  return static_cast<int>(sixteenths);
}

using Owners = std::map<Voxel, Claim>;

// Every voxel against every bound of every packet, in unlimited integers.
Owners brute_force_owners(const PacketStream& stream, int n) {
  Owners owners;
  for (const auto& head : stream.heads) {
    for (int x = head.lo.x; x <= head.hi.x; ++x) {
      for (int y = head.lo.y; y <= head.hi.y; ++y) {
        for (int z = head.lo.z; z <= head.hi.z; ++z) {
          const auto value = [&](const Linear& of) -> cpp_int {
            return cpp_int(of.a) * (x - head.lo.x) + cpp_int(of.b) * (y - head.lo.y) +
                   cpp_int(of.c) * (z - head.lo.z) + of.d;
          };
          const cpp_int height = value(head.slab.value);
          bool in = height >= 0 && height <= head.slab.width, core = true;
          for (std::uint32_t i = 0; i < head.side_count; ++i) {
            const Side& side = stream.sides[head.first_side + i];
            in = in && value(side.value) >= 0;
            core = core && value(side.value) >= side.push;
          }
          if (!in) continue;
          const Claim claim{head.facet, core, brute_force_gap(value(head.gap), n)};
          const auto [owner, first] = owners.try_emplace({x, y, z}, claim);
          if (!first && rank(claim) < rank(owner->second)) owner->second = claim;
        }
      }
    }
  }
  return owners;
}

void expect_owners(GoldenMachine& machine, const Owners& expected) {
  const VoxelMemory voxels = machine.read_voxels();
  ASSERT_EQ(voxels.size(), expected.size());
  for (const VoxelRecord& voxel : voxels) {
    const auto found = expected.find(key(voxel.at));
    ASSERT_NE(found, expected.end());
    EXPECT_EQ(voxel.owner.facet, found->second.facet);
    EXPECT_EQ(voxel.owner.core, found->second.core);
    EXPECT_EQ(voxel.owner.gap, found->second.gap);
  }
}

TEST(GoldenLoad, FillsWhatEveryBoundAllows) {
  Random random(1);
  std::size_t filled = 0;
  for (int round = 0; round < 1000; ++round) {
    const int n = pick(random, 2, 12);
    const std::int64_t largest = std::int64_t{1} << (2 * (coordinate_bits(n) + 4));
    const std::int64_t scale = std::min<std::int64_t>(largest, round % 3 == 0 ? 3 : largest);
    const PacketStream stream = random_packets(random, n, pick(random, 1, 12), scale);
    GoldenMachine machine(machine_config(n));
    machine.load(stream, {});
    SCOPED_TRACE(testing::Message() << "round " << round);
    expect_owners(machine, brute_force_owners(stream, n));
    filled += machine.read_voxels().size();
  }
  EXPECT_GT(filled, 10000U);
}

TEST(GoldenLoad, ListsVoxelsByZThenYThenX) {
  Random random(2);
  GoldenMachine machine(machine_config(9));
  machine.load(random_packets(random, 9, 10, 5), {});
  const VoxelMemory voxels = machine.read_voxels();
  ASSERT_GT(voxels.size(), 10U);
  const auto before = [](const VoxelRecord& a, const VoxelRecord& b) {
    return std::tuple(a.at.z, a.at.y, a.at.x) < std::tuple(b.at.z, b.at.y, b.at.x);
  };
  EXPECT_TRUE(std::is_sorted(voxels.begin(), voxels.end(), before));
}

TEST(GoldenLoad, OwnerDoesNotDependOnTheOrderOfPackets) {
  Random random(3);
  PacketStream stream = random_packets(random, 10, 20, 4);
  GoldenMachine machine(machine_config(10));
  machine.load(stream, {});
  const Owners owners = brute_force_owners(stream, 10);
  expect_owners(machine, owners);
  for (int round = 0; round < 10; ++round) {
    std::shuffle(stream.heads.begin(), stream.heads.end(), random);
    machine.load(stream, {});
    expect_owners(machine, owners);
  }
}

TEST(GoldenLoad, ForgetsWhatWasLoadedBefore) {
  PacketStream stream;
  add_packet(stream, 0, {1, 1, 1}, {2, 2, 2});
  GoldenMachine machine(machine_config(4));
  machine.load(stream, {});
  machine.light({{0, 0, 0}, 3, 1}, {});
  EXPECT_EQ(machine.read_light().size(), 8U);
  machine.load({}, {});
  EXPECT_TRUE(machine.read_voxels().empty());
  EXPECT_TRUE(machine.read_light().empty());
}

TEST(GoldenLoad, RefusesPacketsThatDoNotFit) {
  GoldenMachine machine(machine_config(8));
  const auto refused = [&](const PacketStream& stream) {
    EXPECT_THROW(machine.load(stream, {}), Error);
  };
  const std::int64_t coefficient = std::int64_t{1} << (plane_bits(8, 4) - 1);
  const std::int64_t offset = std::int64_t{1} << (offset_bits(8, 4) - 1);
  const std::int64_t edge = std::int64_t{1} << (side_bits(8, 4) - 1);
  const std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
  const std::int64_t flat = std::int64_t{1} << (gap_value_bits(8) - 1);
  const std::vector<Slab> bad_slabs = {
      {{coefficient, 0, 0, 0}, 0},    {{0, -coefficient - 1, 0, 0}, 0}, {{0, 0, coefficient, 0}, 0},
      {{0, 0, 0, offset}, 0},         {{0, 0, 0, lowest}, 0},           {{0, 0, 0, 0}, -1},
      {{0, 0, 0, 0}, 2 * coefficient}};
  const std::vector<Side> bad_sides = {{{edge, 0, 0, 0}, 0},
                                       {{0, 0, -edge - 1, 0}, 0},
                                       {{0, 0, 0, -offset - 1}, 0},
                                       {{0, 0, 0, 0}, -1},
                                       {{0, 0, 0, 0}, std::int64_t{1} << push_bits(8, 4)}};
  const std::vector<Linear> bad_gaps = {{flat, 0, 0, 0}, {0, 0, -flat - 1, 0}, {0, 0, 0, lowest}};
  for (const Slab& slab : bad_slabs) {
    PacketStream stream;
    add_packet(stream, 0, {0, 0, 0}, {1, 1, 1}, slab);
    refused(stream);
  }
  for (const Side& side : bad_sides) {
    PacketStream stream;
    add_packet(stream, 0, {0, 0, 0}, {1, 1, 1}, {}, {side});
    refused(stream);
  }
  for (const Linear& gap : bad_gaps) {
    PacketStream stream;
    add_packet(stream, 0, {0, 0, 0}, {1, 1, 1}, {}, {}, gap);
    refused(stream);
  }
  const std::vector<std::pair<glm::ivec3, glm::ivec3>> bad_boxes = {
      {{-1, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 8, 1}}, {{2, 2, 2}, {2, 2, 1}}};
  for (const auto& [lo, hi] : bad_boxes) {
    PacketStream stream;
    add_packet(stream, 0, lo, hi);
    refused(stream);
  }
  PacketStream high_number, missing_side;
  add_packet(high_number, kMaxFacets, {0, 0, 0}, {1, 1, 1});
  refused(high_number);
  add_packet(missing_side, 0, {0, 0, 0}, {1, 1, 1}, {}, {Side{}});
  missing_side.sides.pop_back();
  refused(missing_side);
}

// The integer nearest to r, ties downwards, by cases on the two neighbours of r.
std::int64_t nearest_ties_down(Rational r) {
  std::int64_t below = r.numerator() / r.denominator();
  if (Rational(below) > r) --below;
  return r - below <= Rational(1, 2) ? below : below + 1;
}

struct Expected {
  std::map<Voxel, std::uint32_t> arrived;
  TargetCount targets;
  std::int64_t visits = 0;
};

// Every point of the surface of the cube of half-side L once, whatever face it is on; each ray by
// the rational formula.
Expected brute_force_light(const VoxelMemory& voxels, int n, glm::ivec3 source, int distance) {
  Expected expected;
  for (const VoxelRecord& voxel : voxels) expected.arrived[key(voxel.at)] = 0;
  for (int x = -distance; x <= distance; ++x) {
    for (int y = -distance; y <= distance; ++y) {
      for (int z = -distance; z <= distance; ++z) {
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != distance) continue;
        ++expected.targets.total;
        for (int step = 1;; ++step) {
          const auto offset = [&](int target) {
            return nearest_ties_down(Rational(target * step, distance));
          };
          const glm::ivec3 at = source + glm::ivec3(offset(x), offset(y), offset(z));
          if (glm::min(at, glm::ivec3(0)) != glm::ivec3(0) ||
              glm::max(at, glm::ivec3(n - 1)) != glm::ivec3(n - 1)) {
            ++expected.targets.escaped;
            break;
          }
          ++expected.visits;
          const auto hit = expected.arrived.find(key(at));
          if (hit != expected.arrived.end()) {
            ++hit->second;
            ++expected.targets.absorbed;
            break;
          }
        }
      }
    }
  }
  return expected;
}

std::map<Voxel, std::uint32_t> arrived_in(GoldenMachine& machine) {
  std::map<Voxel, std::uint32_t> arrived;
  const VoxelMemory voxels = machine.read_voxels();
  const LightMemory light = machine.read_light();
  EXPECT_EQ(voxels.size(), light.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) arrived[key(voxels[i].at)] = light[i];
  return arrived;
}

PacketStream single_voxels(const std::vector<glm::ivec3>& voxels) {
  PacketStream stream;
  for (const glm::ivec3 voxel : voxels) {
    add_packet(stream, static_cast<std::uint32_t>(stream.heads.size()), voxel, voxel);
  }
  return stream;
}

// A share of isolated voxels, none of them at the source.
std::vector<glm::ivec3> dust(Random& random, int n, glm::ivec3 source, double share) {
  std::vector<glm::ivec3> voxels;
  for (int i = 0; i < static_cast<int>(share * n * n * n); ++i) {
    const glm::ivec3 voxel = pick_voxel(random, n);
    if (voxel != source) voxels.push_back(voxel);
  }
  return voxels;
}

TEST(GoldenLight, CountsTheRaysOfTheRationalFormula) {
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    const int n = pick(random, 2, 8);
    const int distance = pick(random, 1, n + 3);
    const glm::ivec3 source =
        round % 4 == 0 ? glm::ivec3(round % 8 == 0 ? 0 : n - 1) : pick_voxel(random, n);
    GoldenMachine machine(machine_config(n));
    machine.load(single_voxels(dust(random, n, source, 0.15)), {});
    const LightResult result = machine.light({source, distance, 1}, {});
    const Expected expected = brute_force_light(machine.read_voxels(), n, source, distance);
    EXPECT_EQ(arrived_in(machine), expected.arrived) << "n " << n << ", L " << distance;
    EXPECT_EQ(result.targets.total, expected.targets.total);
    EXPECT_EQ(result.targets.absorbed, expected.targets.absorbed);
    EXPECT_EQ(result.targets.escaped, expected.targets.escaped);
    EXPECT_EQ(result.visits, expected.visits);
  }
}

TEST(GoldenLight, LosesNoTarget) {
  Random random(5);
  for (int round = 0; round < 30; ++round) {
    const int n = pick(random, 2, 24);
    const glm::ivec3 source = pick_voxel(random, n);
    GoldenMachine machine(machine_config(n));
    machine.load(single_voxels(dust(random, n, source, 0.05)), {});
    const LightResult result = machine.light({source, pick(random, 1, 40), 1}, {});
    EXPECT_EQ(result.targets.absorbed + result.targets.escaped, result.targets.total);
    EXPECT_EQ(result.targets.skipped, 0);
    std::int64_t arrived = 0;
    for (const std::uint32_t count : machine.read_light()) arrived += count;
    EXPECT_EQ(arrived, result.targets.absorbed);
  }
}

TEST(GoldenLight, EachVoxelOfTheFacesAtDistanceLIsTheTargetOfOneRay) {
  for (int distance = 1; distance <= 6; ++distance) {
    const int n = 2 * distance + 1;
    PacketStream shell;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, n - 1}) {
        glm::ivec3 lo(0), hi(n - 1);
        lo[axis] = hi[axis] = side;
        add_packet(shell, static_cast<std::uint32_t>(shell.heads.size()), lo, hi);
      }
    }
    GoldenMachine machine(machine_config(n));
    machine.load(shell, {});
    machine.light({glm::ivec3(distance), distance, 1}, {});
    const LightMemory light = machine.read_light();
    EXPECT_EQ(light, LightMemory(static_cast<std::size_t>(total_targets(distance)), 1));
  }
}

// Lights the voxels once as they are and once after `move`, which maps the cube onto itself.
template <typename Move>
void expect_symmetric(int n, const std::vector<glm::ivec3>& voxels, glm::ivec3 source, int distance,
                      Move move) {
  std::vector<glm::ivec3> moved(voxels.size());
  std::transform(voxels.begin(), voxels.end(), moved.begin(), move);
  GoldenMachine machine(machine_config(n)), other(machine_config(n));
  machine.load(single_voxels(voxels), {});
  other.load(single_voxels(moved), {});
  machine.light({source, distance, 1}, {});
  other.light({move(source), distance, 1}, {});
  const auto there = arrived_in(other);
  for (const auto& [at, count] : arrived_in(machine)) {
    const auto [x, y, z] = at;
    EXPECT_EQ(count, there.at(key(move(glm::ivec3(x, y, z)))));
  }
}

TEST(GoldenLight, TreatsTheAxesAlike) {
  Random random(6);
  const int n = 9;
  for (const int distance : {4, 7, 8, 11, 16}) {
    const glm::ivec3 source = pick_voxel(random, n);
    const auto voxels = dust(random, n, source, 0.1);
    expect_symmetric(n, voxels, source, distance,
                     [](glm::ivec3 v) { return glm::ivec3(v.y, v.x, v.z); });
    expect_symmetric(n, voxels, source, distance,
                     [](glm::ivec3 v) { return glm::ivec3(v.y, v.z, v.x); });
  }
}

// An odd L has no ties, so nothing prefers a side.
TEST(GoldenLight, TreatsBothSidesAlikeWhenLIsOdd) {
  Random random(7);
  const int n = 9;
  for (const int distance : {3, 7, 9, 15}) {
    const glm::ivec3 source = pick_voxel(random, n);
    const auto voxels = dust(random, n, source, 0.1);
    for (int axis = 0; axis < 3; ++axis) {
      expect_symmetric(n, voxels, source, distance, [&](glm::ivec3 v) {
        v[axis] = n - 1 - v[axis];
        return v;
      });
    }
  }
}

// Thesis 4.1.4: with the faces at L >= n-1 no voxel of the cube is missed.
TEST(GoldenLight, ReachesEveryVoxelOfAnEmptyCube) {
  for (int n = 2; n <= 5; ++n) {
    for (const int distance : {n - 1, n, 2 * n + 1}) {
      GoldenMachine machine(machine_config(n));
      for (int i = 0; i < n * n * n; ++i) {
        const glm::ivec3 voxel(i % n, i / n % n, i / (n * n));
        machine.load(single_voxels({voxel}), {});
        for (int k = 0; k < n * n * n; ++k) {
          if (k == i) continue;
          machine.light({{k % n, k / n % n, k / (n * n)}, distance, 1}, {});
          ASSERT_GE(machine.read_light()[0], 1U);
        }
      }
    }
  }
}

TEST(GoldenLight, ForgetsTheLightBefore) {
  GoldenMachine machine(machine_config(5));
  machine.load(single_voxels({{1, 2, 3}, {4, 4, 4}}), {});
  machine.light({{0, 0, 0}, 4, 1}, {});
  const LightMemory once = machine.read_light();
  machine.light({{0, 0, 0}, 4, 1}, {});
  EXPECT_EQ(machine.read_light(), once);
}

TEST(GoldenLight, HasNoNotionOfTime) {
  GoldenMachine machine(machine_config(3));
  EXPECT_EQ(machine.load({}, {}).cycles, 0);
  const LightResult result = machine.light({{1, 1, 1}, 1, 1}, {});
  EXPECT_EQ(result.cycles, 0);
  EXPECT_EQ(result.home_cycles, 0);
  EXPECT_EQ(result.max_queue, 0);
  EXPECT_EQ(result.visits, 26);
}

TEST(GoldenLight, ReportsProgressUpToTheEnd) {
  GoldenMachine machine(machine_config(6));
  double last = 0;
  machine.light({{1, 2, 3}, 5, 1}, [&](const char* step, std::int64_t, double share) {
    EXPECT_STREQ(step, "light");
    EXPECT_GE(share, last);
    last = share;
  });
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(GoldenLight, RefusesWhatItCannotLight) {
  GoldenMachine machine(machine_config(4, 8));
  machine.load(single_voxels({{1, 2, 3}}), {});
  const glm::ivec3 free(0);
  const std::vector<LightJob> jobs = {{{1, 2, 3}, 3, 1}, {{-1, 0, 0}, 3, 1}, {{0, 4, 0}, 3, 1},
                                      {free, 0, 1},      {free, 9, 1},       {free, 3, 0},
                                      {free, 3, 33}};
  for (const LightJob& job : jobs) EXPECT_THROW(machine.light(job, {}), Error);
  EXPECT_NO_THROW(machine.light({free, 8, 32}, {}));
}

TEST(GoldenMachine, RefusesImpossibleSizes) {
  for (const int n : {-1, 0, 1, kMaxSide + 1}) {
    EXPECT_THROW(GoldenMachine machine(machine_config(n)), Error);
  }
  EXPECT_THROW(GoldenMachine machine(machine_config(4, 0)), Error);
  EXPECT_NO_THROW(GoldenMachine machine(machine_config(2)));
}

}  // namespace
}  // namespace rc2::golden
