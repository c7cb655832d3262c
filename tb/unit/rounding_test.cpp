// Slabs of few bits: what the widened ones promise, and that the others can be seen to break it.
#include "sw/surface/rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numeric>

#include "sw/facet/facet.h"
#include "sw/golden/golden_machine.h"
#include "sw/machine/checks.h"
#include "sw/surface/closed_meshes.h"
#include "sw/surface/rounding_error.h"
#include "tb/load/facet_generator.h"
#include "tb/unit/voxel_set.h"

namespace rc2::surface {
namespace {

using facet::Cube;
using facet::FacetClass;
using facet::PacketHead;
using facet::PacketStream;
using facet::Rule;

constexpr Rule kRules[] = {Rule::armoured, Rule::naive, Rule::supercover, Rule::half,
                           Rule::blindee};

// Facets of every kind, with their packets.
struct Sample {
  Sample(const Cube& of, Rule by, int rounds, std::uint64_t seed) : cube(of), rule(by) {
    scene.materials.resize(1);
    for (int i = 0; i < rounds; ++i)
      for (const FacetClass kind : facet::kFacetClasses)
        for (const facet::Border& border : generate_facets(kind, cube, seed++)) add(border);
    mesh = quantise(scene, cube.fraction_bits);
    packets = build_facets(scene, cube.n, cube.fraction_bits, rule).packets;
  }

  void add(const facet::Border& border) {
    std::vector<glm::dvec3> corners;
    for (const facet::Vertex& v : border)
      corners.push_back(glm::dvec3(v) / static_cast<double>(cube.one()));
    scene.add(corners, 0);
  }

  int exact_bits() const { return plane_bits(cube.n, cube.fraction_bits); }
  PacketStream rounded(int bits, Rounding rounding) const {
    return round_slabs(packets, mesh, bits, rounding);
  }

  Cube cube;
  Rule rule;
  scene::Scene scene;
  Mesh mesh{};
  PacketStream packets;
};

std::vector<Sample> samples() {
  std::vector<Sample> result;
  std::uint64_t seed = 1;
  for (const Rule rule : kRules)
    for (const int n : {2, 3, 16, 33, 64, 256})
      for (const int f : {0, 4, 8})
        result.emplace_back(Cube{n, f}, rule, n < 64 ? 12 : 1, seed++ * 1000);
  return result;
}

// With the largest numbers that there are; too large for a machine in memory.
std::vector<Sample> samples_and_largest() {
  std::vector<Sample> result = samples();
  for (const Rule rule : kRules) result.emplace_back(Cube{kMaxSide, kMaxFractionBits}, rule, 40, 1);
  return result;
}

bool same(const facet::Linear& one, const facet::Linear& other) {
  return one.a == other.a && one.b == other.b && one.c == other.c && one.d == other.d;
}

bool same(const facet::Slab& one, const facet::Slab& other) {
  return same(one.value, other.value) && one.width == other.width;
}

std::array<std::int64_t, 3> sizes_of(const facet::Linear& value) {
  return {std::abs(value.a), std::abs(value.b), std::abs(value.c)};
}

std::int64_t largest_of(const facet::Linear& value) {
  const auto sizes = sizes_of(value);
  return *std::max_element(sizes.begin(), sizes.end());
}

TEST(Rounding, HasTheBitsAskedForAndKeepsWhatFits) {
  for (const Sample& sample : samples_and_largest()) {
    for (int bits = 2; bits <= sample.exact_bits(); ++bits) {
      const std::int64_t largest = (std::int64_t{1} << (bits - 1)) - 1;
      for (const Rounding rounding : kRoundings) {
        const PacketStream rounded = sample.rounded(bits, rounding);
        // Every machine that takes the exact packets takes these.
        ASSERT_NO_THROW(check_packets({sample.cube.n, sample.cube.fraction_bits, 1, 1}, rounded));
        ASSERT_EQ(rounded.heads.size(), sample.packets.heads.size());
        for (std::size_t i = 0; i < rounded.heads.size(); ++i) {
          const facet::Slab &exact = sample.packets.heads[i].slab, &slab = rounded.heads[i].slab;
          if (largest_of(exact.value) <= largest)
            ASSERT_TRUE(same(slab, exact)) << bits;
          else
            ASSERT_EQ(largest_of(slab.value), largest) << bits;
        }
      }
    }
  }
}

TEST(Rounding, ChangesNothingFromTheExactWidthOn) {
  for (const Sample& sample : samples_and_largest()) {
    for (const int bits : {sample.exact_bits(), sample.exact_bits() + 1, 62}) {
      for (const Rounding rounding : kRoundings) {
        const PacketStream rounded = sample.rounded(bits, rounding);
        for (std::size_t i = 0; i < rounded.heads.size(); ++i)
          ASSERT_TRUE(same(rounded.heads[i].slab, sample.packets.heads[i].slab));
      }
    }
  }
}

// How far a point is from the middle of a slab, in voxels along the dominant axis.
double gap(const facet::Slab& slab, const glm::dvec3& at) {
  const facet::Linear& v = slab.value;
  const glm::dvec3 normal(static_cast<double>(v.a), static_cast<double>(v.b),
                          static_cast<double>(v.c));
  const double middle = static_cast<double>(v.d) - 0.5 * static_cast<double>(slab.width);
  return (glm::dot(normal, at) + middle) / static_cast<double>(largest_of(v));
}

TEST(Rounding, TurnsPlanesAboutTheirAnchor) {
  constexpr double kHalfUnit = 0.51;  // both ends of a slab are integers
  for (const Sample& sample : samples()) {
    for (const int bits : {8, 12, 20}) {
      const double unit = 1.0 / ((1 << (bits - 1)) - 1);
      const PacketStream origin = sample.rounded(bits, Rounding::origin);
      const PacketStream centroid = sample.rounded(bits, Rounding::centroid);
      for (std::size_t i = 0; i < sample.packets.heads.size(); ++i) {
        const PacketHead& head = sample.packets.heads[i];
        const facet::Border& border = sample.mesh.facets[head.facet];
        const auto middle =
            glm::dvec3(std::accumulate(border.begin(), border.end(), facet::Vertex(0))) /
                static_cast<double>(sample.cube.one() * static_cast<std::int64_t>(border.size())) -
            glm::dvec3(head.lo);
        ASSERT_NEAR(gap(origin.heads[i].slab, -head.lo), gap(head.slab, -head.lo),
                    kHalfUnit * unit);
        ASSERT_NEAR(gap(centroid.heads[i].slab, middle), gap(head.slab, middle), kHalfUnit * unit);
      }
    }
  }
}

TEST(Widened, MissesNoVoxel) {
  for (const Sample& sample : samples()) {
    const MachineConfig config{sample.cube.n, sample.cube.fraction_bits, 1, 1};
    std::vector<PacketStream> rounded;
    for (int bits = 2; bits <= sample.exact_bits(); ++bits)
      rounded.push_back(sample.rounded(bits, Rounding::widened));
    golden::GoldenMachine machine(config);
    PacketStream alone;
    alone.sides = sample.packets.sides;
    for (std::size_t i = 0; i < sample.packets.heads.size(); ++i) {
      alone.heads = {sample.packets.heads[i]};
      machine.load(alone, {});
      for (const VoxelRecord& voxel : machine.read_voxels())
        for (const PacketStream& stream : rounded)
          ASSERT_TRUE(is_inside(stream, stream.heads[i], voxel.at))
              << "n = " << config.n << ", f = " << config.fraction_bits << ", "
              << to_string(sample.rule) << ", facet " << i << ", largest coefficient "
              << largest_of(stream.heads[i].slab.value);
    }
  }
}

// Twice S' + 1 + half the steps of the box along the two axes that are not dominant.
std::int64_t twice_widest(const PacketHead& exact, const facet::Linear& rounded) {
  const auto exact_sizes = sizes_of(exact.slab.value), sizes = sizes_of(rounded);
  const auto dominant = std::max_element(exact_sizes.begin(), exact_sizes.end());
  glm::ivec3 steps = exact.hi - exact.lo;
  steps[static_cast<int>(dominant - exact_sizes.begin())] = 0;
  return 2 * std::accumulate(sizes.begin(), sizes.end(), std::int64_t{1}) + steps.x + steps.y +
         steps.z;
}

TEST(Widened, IsNoThickerThanProven) {
  for (const Sample& sample : samples_and_largest()) {
    if (sample.rule != Rule::armoured) continue;
    for (int bits = 2; bits <= sample.exact_bits(); ++bits) {
      const PacketStream rounded = sample.rounded(bits, Rounding::widened);
      for (std::size_t i = 0; i < rounded.heads.size(); ++i) {
        const facet::Slab& slab = rounded.heads[i].slab;
        ASSERT_LE(2 * slab.width, twice_widest(sample.packets.heads[i], slab.value)) << bits;
      }
    }
  }
}

TEST(Widened, LetsNothingThroughClosedMeshes) {
  for (const MeshFamily& family : kMeshFamilies) {
    const RoundingTrial trial(make_mesh(family, 11), family.n);
    for (const int bits : {2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 20}) {
      const RoundingError error = trial.measure(bits, Rounding::widened);
      EXPECT_EQ(error.missing, 0) << family.name << ", " << bits << " bits";
      EXPECT_EQ(error.tunnels.by_26, 0) << family.name << ", " << bits << " bits";
    }
  }
}

// Planes along the axes fit in two bits; all others leak, or zeros above would mean nothing.
TEST(Others, LeakWhenBitsAreFew) {
  for (const MeshFamily& family : kMeshFamilies) {
    const RoundingTrial trial(make_mesh(family, 11), family.n);
    for (const Rounding rounding : {Rounding::origin, Rounding::centroid}) {
      std::int64_t missing = 0, tunnels = 0;
      for (const int bits : {2, 3, 4, 5, 6}) {
        const RoundingError error = trial.measure(bits, rounding);
        missing += error.missing;
        tunnels += error.tunnels.by_26;
      }
      const bool along_axes = family.name == std::string("axis boxes");
      EXPECT_EQ(missing == 0, along_axes) << family.name << ", " << to_string(rounding);
      EXPECT_EQ(tunnels == 0, along_axes) << family.name << ", " << to_string(rounding);
    }
  }
}

TEST(Trial, CountsVoxelsThatComeAndGo) {
  const MeshFamily& family = kMeshFamilies.front();
  const scene::Scene scene = make_mesh(family, 1);
  const int n = family.n, f = MachineConfig{}.fraction_bits;
  const PacketStream exact = build_facets(scene, n, f, Rule::armoured).packets;
  const PacketStream rounded = round_slabs(exact, quantise(scene, f), 6, Rounding::origin);
  const facet::VoxelSet before(exact, n), after(rounded, n);
  std::int64_t missing = 0, extra = 0;
  for (int i = 0; i < n * n * n; ++i) {
    const glm::ivec3 at(i % n, i / n % n, i / n / n);
    missing += before.has(at) && !after.has(at);
    extra += after.has(at) && !before.has(at);
  }
  const RoundingTrial trial(scene, n);
  const RoundingError error = trial.measure(6, Rounding::origin);
  EXPECT_EQ(trial.facets(), 4);
  EXPECT_EQ(trial.voxels(), static_cast<std::int64_t>(before.count()));
  EXPECT_GT(missing, 0);
  EXPECT_GT(extra, 0);
  EXPECT_EQ(error.missing, missing);
  EXPECT_EQ(error.extra, extra);
}

}  // namespace
}  // namespace rc2::surface
