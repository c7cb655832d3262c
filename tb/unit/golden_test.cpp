#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/rational.hpp>
#include <glm/common.hpp>
#include <limits>
#include <map>
#include <tuple>

#include "sw/golden/golden_machine.h"
#include "tb/unit/random_packets.h"

namespace rc2::golden {
namespace {

using Exact = boost::multiprecision::checked_int256_t;
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

// Core first, then the nearest plane, then the lowest number. Gaps of the same size in front of and
// behind a plane are -1 and 0, -2 and 1, ...
using Rank = std::tuple<bool, int, std::uint32_t>;
Rank rank(const Claim& claim) {
  return {!claim.core, std::max(claim.gap, -1 - claim.gap), claim.facet};
}

// Sixteenths, rounded down, of which only what lies within four voxels is kept.
int brute_force_gap(const Exact& value, int n) {
  const Exact unit = Exact(1) << (coordinate_bits(n) + 2);
  Exact sixteenths = value / unit;
  if (sixteenths * unit > value) --sixteenths;
  while (sixteenths >= 64) sixteenths -= 128;
  while (sixteenths < -64) sixteenths += 128;
  return static_cast<int>(sixteenths);
}

using Owners = std::map<Voxel, Claim>;

Exact value_at(const Linear& of, const glm::ivec3& at) {
  return Exact(of.a) * at.x + Exact(of.b) * at.y + Exact(of.c) * at.z + of.d;
}

// Calls visit(voxel, core) for every voxel of the packet: each against every bound, in wide
// integers.
template <typename Visit>
void for_each_filled(const PacketStream& stream, const facet::PacketHead& head, Visit visit) {
  glm::ivec3 at;
  for (at.x = head.lo.x; at.x <= head.hi.x; ++at.x) {
    for (at.y = head.lo.y; at.y <= head.hi.y; ++at.y) {
      for (at.z = head.lo.z; at.z <= head.hi.z; ++at.z) {
        const Exact height = value_at(head.slab.value, at - head.lo);
        bool in = height >= 0 && (head.layer == facet::Layer::inside || height <= head.slab.width);
        bool core = true;
        for (std::uint32_t i = 0; i < head.side_count; ++i) {
          const Side& side = stream.sides[head.first_side + i];
          const Exact value = value_at(side.value, at - head.lo);
          in = in && value >= 0;
          core = core && value >= side.push;
        }
        if (in) visit(at, core);
      }
    }
  }
}

Owners brute_force_owners(const PacketStream& stream, int n) {
  Owners owners;
  for (const auto& head : stream.heads) {
    if (head.layer != facet::Layer::armour) continue;
    for_each_filled(stream, head, [&](const glm::ivec3& at, bool core) {
      const Claim claim{head.facet, core, brute_force_gap(value_at(head.gap, at - head.lo), n)};
      const auto [owner, first] = owners.try_emplace(key(at), claim);
      if (!first && rank(claim) < rank(owner->second)) owner->second = claim;
    });
  }
  return owners;
}

struct VoxelLayers {
  bool shown = false, inside = false, guard = false, parity = false;
};

// The layers by their definition, batch by batch.
std::map<Voxel, VoxelLayers> brute_force_layers(const PacketStream& stream, int n,
                                                const Owners& owners) {
  std::map<Voxel, VoxelLayers> layers;
  for (const auto& batch : stream.batches) {
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
      const facet::PacketHead& head = stream.heads[i];
      std::map<std::pair<int, int>, int> lowest;  // filled voxel of a column
      for_each_filled(stream, head, [&](const glm::ivec3& at, bool) {
        if (head.layer == facet::Layer::shown) layers[key(at)].shown = true;
        if (head.layer == facet::Layer::guard && owners.count(key(at)) == 0)
          layers[key(at)].guard = true;
        const auto [low, first] = lowest.try_emplace({at.x, at.y}, at.z);
        if (!first) low->second = std::min(low->second, at.z);
      });
      if (head.layer != facet::Layer::inside) continue;
      for (const auto& [column, low] : lowest)
        for (int z = low; z < n; ++z) {
          bool& parity = layers[{column.first, column.second, z}].parity;
          parity = !parity;
        }
    }
    if (!batch.ends_object) continue;
    for (auto& [at, voxel] : layers) {
      voxel.inside = voxel.inside || voxel.parity;
      voxel.parity = false;
    }
  }
  return layers;
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
  Dice dice(1);
  std::size_t filled = 0;
  for (int round = 0; round < 1000; ++round) {
    const int n = pick(dice, 2, 12);
    const std::int64_t largest = std::int64_t{1} << (2 * (coordinate_bits(n) + 4));
    const std::int64_t scale = std::min<std::int64_t>(largest, round % 3 == 0 ? 3 : largest);
    const PacketStream stream = random_packets(dice, n, pick(dice, 1, 12), scale);
    GoldenMachine machine(machine_config(n));
    machine.load(stream, {});
    SCOPED_TRACE(testing::Message() << "round " << round);
    expect_owners(machine, brute_force_owners(stream, n));
    filled += machine.read_voxels().size();
  }
  EXPECT_GT(filled, 10000U);
}

TEST(GoldenLoad, KeepsTheLayersByTheirDefinition) {
  Dice dice(4);
  std::int64_t shown = 0, inside = 0, guard = 0;
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const int n = pick(dice, 2, 8);
    const std::int64_t scale =
        round % 2 == 0 ? 3 : std::int64_t{1} << (2 * (coordinate_bits(n) + 4));
    const PacketStream stream = random_layers(dice, n, pick(dice, 1, 40), scale);
    GoldenMachine machine(machine_config(n));
    machine.load(stream, {});
    const Owners owners = brute_force_owners(stream, n);
    auto expected = brute_force_layers(stream, n, owners);
    std::size_t found = 0;
    for (const LayerRecord& voxel : machine.read_layers()) {
      const VoxelLayers& want = expected[key(voxel.at)];
      EXPECT_EQ(voxel.armour, owners.count(key(voxel.at)) > 0);
      EXPECT_EQ(voxel.shown, want.shown);
      EXPECT_EQ(voxel.inside, want.inside);
      EXPECT_EQ(voxel.guard, want.guard);
      shown += voxel.shown;
      inside += voxel.inside;
      guard += voxel.guard;
      ++found;
    }
    for (const auto& [at, owner] : owners) expected.try_emplace(at);
    const auto any = [&](const auto& entry) {
      const auto& [at, voxel] = entry;
      return voxel.shown || voxel.inside || voxel.guard || owners.count(at) > 0;
    };
    EXPECT_EQ(found,
              static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), any)));
  }
  EXPECT_GT(shown, 3000);
  EXPECT_GT(inside, 3000);
  EXPECT_GT(guard, 200);
}

TEST(GoldenLoad, ListsVoxelsByZThenYThenX) {
  Dice dice(2);
  GoldenMachine machine(machine_config(9));
  machine.load(random_packets(dice, 9, 10, 5), {});
  const VoxelMemory voxels = machine.read_voxels();
  ASSERT_GT(voxels.size(), 10U);
  const auto before = [](const VoxelRecord& a, const VoxelRecord& b) {
    return std::tuple(a.at.z, a.at.y, a.at.x) < std::tuple(b.at.z, b.at.y, b.at.x);
  };
  EXPECT_TRUE(std::is_sorted(voxels.begin(), voxels.end(), before));
}

TEST(GoldenLoad, OwnerDoesNotDependOnTheOrderOfPackets) {
  Dice dice(3);
  PacketStream stream = random_packets(dice, 10, 20, 4);
  GoldenMachine machine(machine_config(10));
  machine.load(stream, {});
  const Owners owners = brute_force_owners(stream, 10);
  expect_owners(machine, owners);
  for (int round = 0; round < 10; ++round) {
    dice.shuffle(stream.heads.begin(), stream.heads.end());
    machine.load(stream, {});
    expect_owners(machine, owners);
  }
}

TEST(GoldenLoad, ForgetsWhatWasLoadedBefore) {
  PacketStream stream;
  add_packet(stream, 0, {1, 1, 1}, {2, 2, 2});
  GoldenMachine machine(machine_config(4));
  const LightMemory dark(8, 0);
  machine.load(stream, {});
  EXPECT_EQ(machine.read_light(), dark);
  machine.light({{0, 0, 0}, 3, 1}, {});
  EXPECT_NE(machine.read_light(), dark);
  machine.load(stream, {});
  EXPECT_EQ(machine.read_light(), dark);
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
  const std::int64_t steep = (std::int64_t{1} << gap_fraction_bits(8)) + 1;
  const std::vector<Slab> bad_slabs = {{{coefficient, 0, 0, 0}, 0},
                                       {{0, -coefficient - 1, 0, 0}, 0},
                                       {{0, 0, coefficient, 0}, 0},
                                       {{0, 0, 0, offset}, 0},
                                       {{0, 0, 0, lowest}, 0},
                                       {{0, 0, 0, 0}, -1},
                                       {{0, 0, 0, 0}, std::int64_t{1} << width_bits(8, 4)}};
  const std::vector<Side> bad_sides = {{{edge, 0, 0, 0}, 0},
                                       {{0, 0, -edge - 1, 0}, 0},
                                       {{0, 0, 0, -offset - 1}, 0},
                                       {{0, 0, 0, 0}, -1},
                                       {{0, 0, 0, 0}, std::int64_t{1} << push_bits(8, 4)}};
  const std::vector<Linear> bad_gaps = {{steep, 0, 0, 0}, {0, 0, -steep, 0}, {0, 0, 0, lowest}};
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
std::vector<glm::ivec3> dust(Dice& dice, int n, glm::ivec3 source, double share) {
  std::vector<glm::ivec3> voxels;
  for (int i = 0; i < static_cast<int>(share * n * n * n); ++i) {
    const glm::ivec3 voxel = pick_voxel(dice, n);
    if (voxel != source) voxels.push_back(voxel);
  }
  return voxels;
}

TEST(GoldenLight, CountsTheRaysOfTheRationalFormula) {
  Dice dice(4);
  for (int round = 0; round < 20; ++round) {
    const int n = pick(dice, 2, 8);
    const int distance = pick(dice, 1, n + 3);
    const glm::ivec3 source =
        round % 4 == 0 ? glm::ivec3(round % 8 == 0 ? 0 : n - 1) : pick_voxel(dice, n);
    GoldenMachine machine(machine_config(n));
    machine.load(single_voxels(dust(dice, n, source, 0.15)), {});
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
  Dice dice(5);
  for (int round = 0; round < 30; ++round) {
    const int n = pick(dice, 2, 24);
    const glm::ivec3 source = pick_voxel(dice, n);
    GoldenMachine machine(machine_config(n));
    machine.load(single_voxels(dust(dice, n, source, 0.05)), {});
    const LightResult result = machine.light({source, pick(dice, 1, 40), 1}, {});
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
  Dice dice(6);
  const int n = 9;
  for (const int distance : {4, 7, 8, 11, 16}) {
    const glm::ivec3 source = pick_voxel(dice, n);
    const auto voxels = dust(dice, n, source, 0.1);
    expect_symmetric(n, voxels, source, distance,
                     [](glm::ivec3 v) { return glm::ivec3(v.y, v.x, v.z); });
    expect_symmetric(n, voxels, source, distance,
                     [](glm::ivec3 v) { return glm::ivec3(v.y, v.z, v.x); });
  }
}

// An odd L has no ties, so nothing prefers a side.
TEST(GoldenLight, TreatsBothSidesAlikeWhenLIsOdd) {
  Dice dice(7);
  const int n = 9;
  for (const int distance : {3, 7, 9, 15}) {
    const glm::ivec3 source = pick_voxel(dice, n);
    const auto voxels = dust(dice, n, source, 0.1);
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
