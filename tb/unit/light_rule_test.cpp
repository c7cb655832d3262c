// The accurate light rule of the golden model against its definition, and on bodies where what is
// lit is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/rational.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "sw/cycle/cycle_machine.h"
#include "sw/facet/layers.h"
#include "sw/facet/turns_away.h"
#include "sw/golden/golden_machine.h"
#include "sw/scene/shapes.h"
#include "tb/stress/light_oracle.h"
#include "tb/unit/random_packets.h"

namespace rc2::golden {
namespace {

using Rational = boost::rational<std::int64_t>;
using Voxel = std::tuple<int, int, int>;

Voxel key(const glm::ivec3& at) { return {at.x, at.y, at.z}; }

MachineConfig config_of(int n, int fraction_bits = 4) {
  MachineConfig config;
  config.n = n;
  config.fraction_bits = fraction_bits;
  config.max_distance = 4 * n;
  return config;
}

TEST(AccurateLight, IsWhatItsDefinitionSays) {
  Dice dice(1);
  std::int64_t passed = 0, guarded = 0;
  for (int round = 0; round < 240; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const int n = pick(dice, 3, 9), distance = pick(dice, 1, 2 * n), count = pick(dice, 2, 24);
    const facet::PacketStream stream = random_layers(dice, n, count, 3);
    GoldenMachine machine(config_of(n));
    machine.load(stream, {});
    const stress::LightOracle oracle(n, machine.read_voxels(), machine.read_layers(), stream);
    const glm::ivec3 source = pick_voxel(dice, n);
    if (oracle.is_armoured(source)) continue;
    const LightJob job{source, distance, 1, LightRule::accurate};
    const stress::ExpectedLight expected = oracle.light(job);
    const LightResult result = machine.light(job, {});
    EXPECT_EQ(result.targets.absorbed, expected.targets.absorbed);
    EXPECT_EQ(result.targets.escaped, expected.targets.escaped);
    EXPECT_EQ(result.targets.total, total_targets(distance));
    EXPECT_EQ(expected.targets.total, total_targets(distance));
    EXPECT_EQ(result.visits, expected.visits);
    EXPECT_EQ(machine.read_light(), expected.arrived);
    passed += expected.passed;
    guarded += expected.guarded;
  }
  EXPECT_GT(passed, 5000);
  EXPECT_GT(guarded, 1000);
}

TEST(AccurateLight, IsTheThesisRuleInACrowd) {
  Dice dice(2);
  for (int round = 0; round < 20; ++round) {
    const int n = pick(dice, 3, 16), count = pick(dice, 1, 12);
    facet::PacketStream stream = random_packets(dice, n, count, 3);
    for (facet::PacketHead& head : stream.heads) head.surface = facet::Surface::crowd;
    GoldenMachine machine(config_of(n));
    machine.load(stream, {});
    const glm::ivec3 source = pick_voxel(dice, n);
    try {
      const LightResult thesis = machine.light({source, 2 * n, 1}, {});
      const LightMemory arrived = machine.read_light();
      const LightResult accurate = machine.light({source, 2 * n, 1, LightRule::accurate}, {});
      EXPECT_EQ(machine.read_light(), arrived);
      EXPECT_EQ(accurate.visits, thesis.visits);
      EXPECT_EQ(accurate.targets.absorbed, thesis.targets.absorbed);
    } catch (const Error&) {  // the source is occupied
    }
  }
}

// A convex body: what faces the light is lit, what turns away is dark, but for the voxels that
// touch both kinds.
template <class Body>
void expect_lit_where_it_faces(const Body& add_body, const glm::ivec3& light) {
  const int n = 48, fraction_bits = 6;
  scene::Scene scene;
  scene.materials.resize(1);
  add_body(scene);
  const facet::FacetSet set = facet::build_layers(scene, n, fraction_bits);
  GoldenMachine machine(config_of(n, fraction_bits));
  machine.load(set.packets, {});
  machine.light({light, 2 * n, 1, LightRule::accurate}, {});
  const VoxelMemory voxels = machine.read_voxels();
  const LightMemory arrived = machine.read_light();
  std::map<Voxel, bool> away, shown;
  for (const VoxelRecord& voxel : voxels)
    away[key(voxel.at)] = turns_away(set.facets[voxel.owner.facet], light, fraction_bits);
  for (const LayerRecord& layer : machine.read_layers()) shown[key(layer.at)] = layer.shown;
  int lit = 0, dark = 0;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const glm::ivec3 at = voxels[i].at;
    if (!shown[key(at)]) continue;
    bool is_border = false;
    for (int k = 0; k < 125; ++k) {
      const auto other = away.find(key(at + glm::ivec3(k % 5, k / 5 % 5, k / 25) - 2));
      is_border = is_border || (other != away.end() && other->second != away[key(at)]);
    }
    if (is_border) continue;
    // Light that skims a facet which hardly turns away reaches the armour in front of it.
    const glm::vec3 way = glm::normalize(glm::vec3(light - at));
    if (std::abs(glm::dot(set.facets[voxels[i].owner.facet].normal, way)) < 0.25F) continue;
    EXPECT_EQ(arrived[i] > 0, !away[key(at)]) << at.x << ' ' << at.y << ' ' << at.z;
    (away[key(at)] ? dark : lit) += 1;
  }
  EXPECT_GT(lit, 100);
  EXPECT_GT(dark, 100);
}

TEST(AccurateLight, AConvexBodyIsLitWhereItFacesTheLight) {
  for (const glm::ivec3 light :
       {glm::ivec3(45, 44, 40), glm::ivec3(2, 24, 30), glm::ivec3(24, 3, 1)}) {
    expect_lit_where_it_faces(
        [](scene::Scene& scene) { scene::add_sphere(scene, glm::dvec3(23.6), 14, 0.5, 0); }, light);
    scene::Random random(3);
    const glm::dmat3 axes = scene::random_rotation(random);
    expect_lit_where_it_faces(
        [&](scene::Scene& scene) {
          scene::add_box(scene, {glm::dvec3(23.4), {9, 11, 8}, axes}, 0);
        },
        light);
  }
}

// A wall across the cube and a body behind it.
TEST(AccurateLight, NothingBehindAWallIsLitHoweverThin) {
  const int n = 32, fraction_bits = 6;
  scene::Random random(4);
  int behind = 0;
  for (const double thickness : {0.0, 0.3, 1.0, 1.7, 4.0}) {
    for (int trial = 0; trial < 12; ++trial) {
      scene::Scene scene;
      scene.materials.resize(1);
      const glm::dvec2 slope(random.between(-0.45, 0.45), random.between(-0.45, 0.45));
      const auto height = [&](double x, double y) {
        return 18 + slope.x * (x - 15.5) + slope.y * (y - 15.5);
      };
      const auto wall = [&](double x, double y) { return glm::dvec3(x, y, height(x, y)); };
      const std::vector<glm::dvec3> top{wall(0, 0), wall(31, 0), wall(31, 31), wall(0, 31)};
      if (std::any_of(top.begin(), top.end(), [](const auto& v) { return v.z > 31 || v.z < 4; }))
        continue;
      const glm::dvec3 down(0, 0, -thickness);
      scene.add(top, 0);
      if (thickness > 0) {
        scene.add({top[3] + down, top[2] + down, top[1] + down, top[0] + down}, 0);
        for (std::size_t i = 0; i < 4; ++i)
          scene.add({top[(i + 1) % 4], top[i], top[i] + down, top[(i + 1) % 4] + down}, 0);
      }
      scene::add_sphere(scene, {15, 15, 4.5}, 3, 0.5, 0);
      const facet::FacetSet set = facet::build_layers(scene, n, fraction_bits);
      GoldenMachine machine(config_of(n, fraction_bits));
      machine.load(set.packets, {});
      glm::ivec3 light{random.below(n), random.below(n), 31};
      if (light.z < height(light.x, light.y) + 2) continue;
      machine.light({light, 2 * n, 1, LightRule::accurate}, {});
      const VoxelMemory voxels = machine.read_voxels();
      const LightMemory arrived = machine.read_light();
      for (std::size_t i = 0; i < voxels.size(); ++i) {
        const glm::ivec3 at = voxels[i].at;
        if (at.z > height(at.x, at.y) - thickness - 2) continue;
        EXPECT_EQ(arrived[i], 0U) << thickness << ", trial " << trial;
        ++behind;
      }
    }
  }
  EXPECT_GT(behind, 5'000);
}

TEST(AccurateLight, AsksForAMachineThatKnowsIt) {
  const LightJob job{{1, 1, 1}, 8, 1, LightRule::accurate};
  GoldenMachine golden(config_of(8));
  EXPECT_NO_THROW(golden.light(job, {}));
  cycle::CycleMachine cycle(config_of(8));
  EXPECT_NO_THROW(cycle.light(job, {}));
  MachineConfig config = config_of(8);
  config.layers = false;
  cycle::CycleMachine without_layers(config);
  EXPECT_THROW(without_layers.light(job, {}), Error);
  config = config_of(8);
  config.mode = LightMode::thesis;
  cycle::CycleMachine thesis(config);
  EXPECT_THROW(thesis.light(job, {}), Error);
}

TEST(TurnsAway, IsTheExactSideOfThePlane) {
  Dice dice(5);
  int on_plane = 0;
  for (int i = 0; i < 3000; ++i) {
    const int f = pick(dice, 0, 3);
    const auto vertex = [&] { return facet::Vertex(pick_voxel(dice, 5)); };
    const facet::Vertex a = vertex(), b = vertex(), c = vertex();
    const facet::Vertex normal = facet::cross(b - a, c - a);
    const facet::FacetInfo info{{}, 0, {normal, facet::dot(normal, a)}};
    const glm::ivec3 light = pick_voxel(dice, 5);
    Rational side(0);
    for (int axis = 0; axis < 3; ++axis)
      side += Rational(normal[axis]) * (Rational(light[axis]) - Rational(a[axis], 1 << f));
    on_plane += side == 0;
    EXPECT_EQ(facet::turns_away(info, light, f), side <= 0);
  }
  EXPECT_GT(on_plane, 5);
}

}  // namespace
}  // namespace rc2::golden
