// The accurate light rule of the golden model against its definition, and on bodies where what is
// lit is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/rational.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <tuple>

#include "sw/cycle/cycle_machine.h"
#include "sw/facet/blocking.h"
#include "sw/facet/layers.h"
#include "sw/golden/golden_machine.h"
#include "sw/scene/shapes.h"
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

std::int64_t nearest_ties_down(const Rational& r) {
  const Rational doubled = 2 * r - 1;  // the least integer not below r - 1/2
  std::int64_t floor = doubled.numerator() / (2 * doubled.denominator());
  while (Rational(floor) < r - Rational(1, 2)) ++floor;
  while (Rational(floor - 1) >= r - Rational(1, 2)) --floor;
  return floor;
}

std::vector<glm::ivec3> ray(int n, const glm::ivec3& source, const glm::ivec3& target,
                            int distance) {
  std::vector<glm::ivec3> voxels;
  for (int step = 1;; ++step) {
    glm::ivec3 at;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = source[axis] +
                 static_cast<int>(nearest_ties_down(Rational(target[axis] * step, distance)));
    if (glm::clamp(at, 0, n - 1) != at) return voxels;
    voxels.push_back(at);
  }
}

// The rule as docs/light.md words it, on one whole ray.
class Definition {
 public:
  Definition(GoldenMachine& machine, const facet::PacketStream& stream,
             const std::vector<bool>& blocking)
      : blocking_(blocking) {
    for (const VoxelRecord& voxel : machine.read_voxels()) owners_[key(voxel.at)] = voxel.owner;
    for (const LayerRecord& layer : machine.read_layers()) layers_.emplace(key(layer.at), layer);
    for (const facet::PacketHead& head : stream.heads)
      if (head.layer == facet::Layer::armour) facing_[head.facet] = head.facing;
  }

  // How many voxels of the ray light reaches; is_home: whether the last of them ends it.
  std::size_t reach(const std::vector<glm::ivec3>& voxels, bool& is_home) const {
    is_home = true;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      if (!is_armoured(voxels[i])) {
        if (is_inside(voxels[i])) return i + 1;
        if (i > 0 && came_through(voxels, i)) return i + 1;
      } else if (!is_thin(voxels[i])) {
        if (blocks(voxels[i])) return i + 1;
        if (i > 0 && was_behind(voxels, i)) return i + 1;
      }
    }
    is_home = false;
    return voxels.size();
  }

  bool is_armoured(const glm::ivec3& at) const { return owners_.count(key(at)) > 0; }

 private:
  bool is_inside(const glm::ivec3& at) const {
    return layers_.count(key(at)) > 0 && layers_.at(key(at)).inside;
  }
  bool is_thin(const glm::ivec3& at) const {
    return layers_.count(key(at)) > 0 && layers_.at(key(at)).thin;
  }
  bool blocks(const glm::ivec3& at) const { return blocking_[owners_.at(key(at)).facet]; }
  bool is_in_front(const glm::ivec3& at) const {
    return (owners_.at(key(at)).gap >= 0) == !blocks(at);
  }
  // The last thin voxel before voxel i of the ray.
  std::optional<std::size_t> last_thin(const std::vector<glm::ivec3>& voxels, std::size_t i) const {
    while (i-- > 0)
      if (is_armoured(voxels[i]) && is_thin(voxels[i])) return i;
    return {};
  }
  bool was_behind(const std::vector<glm::ivec3>& voxels, std::size_t i) const {
    const auto thin = last_thin(voxels, i);
    return thin && !is_in_front(voxels[*thin]);
  }
  bool came_through(const std::vector<glm::ivec3>& voxels, std::size_t i) const {
    const auto thin = last_thin(voxels, i);
    if (!thin) return false;
    if (!is_in_front(voxels[*thin])) return true;
    const glm::ivec3 step = voxels[*thin + 1] - voxels[*thin];
    int code = facing_.at(owners_.at(key(voxels[*thin])).facet);
    if (blocks(voxels[*thin])) code = 26 - code;
    return (code / 9 - 1) * step.x + (code / 3 % 3 - 1) * step.y + (code % 3 - 1) * step.z < 0;
  }

  const std::vector<bool>& blocking_;
  std::map<Voxel, Claim> owners_;
  std::map<Voxel, LayerRecord> layers_;
  std::map<std::uint32_t, int> facing_;
};

TEST(AccurateLight, IsWhatItsDefinitionSays) {
  Dice dice(1);
  std::int64_t passed = 0;
  for (int round = 0; round < 120; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const int n = pick(dice, 3, 9), distance = pick(dice, 1, 2 * n), count = pick(dice, 2, 24);
    const facet::PacketStream stream = random_layers(dice, n, count, 3);
    GoldenMachine machine(config_of(n));
    machine.load(stream, {});
    std::vector<bool> blocking(static_cast<std::size_t>(count));
    std::generate(blocking.begin(), blocking.end(), [&] { return pick(dice, 0, 2) == 0; });
    const Definition definition(machine, stream, blocking);
    glm::ivec3 source = pick_voxel(dice, n);
    for (int tries = 0; tries < 100 && definition.is_armoured(source); ++tries)
      source = pick_voxel(dice, n);
    if (definition.is_armoured(source)) continue;

    std::map<Voxel, std::uint32_t> expected;
    std::int64_t absorbed = 0, visits = 0;
    for (int x = -distance; x <= distance; ++x)
      for (int y = -distance; y <= distance; ++y)
        for (int z = -distance; z <= distance; ++z) {
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != distance) continue;
          const std::vector<glm::ivec3> voxels = ray(n, source, {x, y, z}, distance);
          bool is_home = false;
          const std::size_t reach = definition.reach(voxels, is_home);
          absorbed += is_home;
          visits += static_cast<std::int64_t>(reach);
          for (std::size_t i = 0; i < reach; ++i) {
            ++expected[key(voxels[i])];
            passed += i + 1 < reach && definition.is_armoured(voxels[i]) ? 1 : 0;
          }
        }
    const LightResult result =
        machine.light({source, distance, 1, LightRule::accurate, &blocking}, {});
    EXPECT_EQ(result.targets.absorbed, absorbed);
    EXPECT_EQ(result.targets.escaped, result.targets.total - absorbed);
    EXPECT_EQ(result.targets.total, total_targets(distance));
    EXPECT_EQ(result.visits, visits);
    const VoxelMemory voxels = machine.read_voxels();
    const LightMemory arrived = machine.read_light();
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      EXPECT_EQ(arrived[i], expected[key(voxels[i].at)]);
    }
  }
  EXPECT_GT(passed, 5000);
}

TEST(AccurateLight, IsTheThesisRuleWhereEveryFacetBlocksAndNothingIsInsideOrThin) {
  Dice dice(2);
  for (int round = 0; round < 20; ++round) {
    const int n = pick(dice, 3, 16), count = pick(dice, 1, 12);
    const facet::PacketStream stream = random_packets(dice, n, count, 3);
    GoldenMachine machine(config_of(n));
    machine.load(stream, {});
    const std::vector<bool> blocking(static_cast<std::size_t>(count), true);
    const glm::ivec3 source = pick_voxel(dice, n);
    try {
      const LightResult thesis = machine.light({source, 2 * n, 1}, {});
      const LightMemory arrived = machine.read_light();
      const LightResult accurate =
          machine.light({source, 2 * n, 1, LightRule::accurate, &blocking}, {});
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
  const std::vector<bool> blocking = facet::find_blocking(set.facets, light, fraction_bits);
  machine.light({light, 2 * n, 1, LightRule::accurate, &blocking}, {});
  const VoxelMemory voxels = machine.read_voxels();
  const LightMemory arrived = machine.read_light();
  std::map<Voxel, bool> away, shown;
  for (const VoxelRecord& voxel : voxels) away[key(voxel.at)] = blocking[voxel.owner.facet];
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

TEST(AccurateLight, NothingBehindAWallIsLitHoweverThin) {
  const int n = 32, fraction_bits = 6;
  scene::Random random(4);
  for (const double thickness : {0.0, 0.3, 1.0, 1.7, 4.0}) {
    // A wall across the cube, a body behind it.
    for (int trial = 0; trial < 6; ++trial) {
      scene::Scene scene;
      scene.materials.resize(1);
      const double slope = random.between(-4, 4), height = random.between(13, 17);
      const auto wall = [&](double x, double y) {
        return glm::dvec3(x, y, height + slope * (x - 15.5) / 15.5);
      };
      const std::vector<glm::dvec3> top{wall(0, 0), wall(31, 0), wall(31, 31), wall(0, 31)};
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
      const glm::ivec3 light{random.below(n), random.below(n), 28};
      const std::vector<bool> blocking = facet::find_blocking(set.facets, light, fraction_bits);
      machine.light({light, 2 * n, 1, LightRule::accurate, &blocking}, {});
      const VoxelMemory voxels = machine.read_voxels();
      const LightMemory arrived = machine.read_light();
      for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (voxels[i].at.z >= 9) continue;
        EXPECT_EQ(arrived[i], 0U) << thickness << ", trial " << trial;
      }
    }
  }
}

TEST(AccurateLight, AsksWhichFacetsBlockAndForAMachineThatKnowsIt) {
  GoldenMachine golden(config_of(8));
  cycle::CycleMachine cycle(config_of(8));
  const std::vector<bool> blocking;
  EXPECT_THROW(golden.light({{1, 1, 1}, 8, 1, LightRule::accurate}, {}), Error);
  EXPECT_NO_THROW(golden.light({{1, 1, 1}, 8, 1, LightRule::accurate, &blocking}, {}));
  EXPECT_THROW(cycle.light({{1, 1, 1}, 8, 1, LightRule::accurate, &blocking}, {}), Error);
}

TEST(Blocking, IsTheExactSideOfThePlane) {
  Dice dice(5);
  int on_plane = 0;
  for (int i = 0; i < 3000; ++i) {
    const int f = pick(dice, 0, 3);
    const auto vertex = [&] { return facet::Vertex(pick_voxel(dice, 5)); };
    const facet::Vertex a = vertex(), b = vertex(), c = vertex();
    const facet::Vertex normal = facet::cross(b - a, c - a);
    facet::FacetInfo info{{}, 0, {normal, facet::dot(normal, a)}};
    const glm::ivec3 light = pick_voxel(dice, 5);
    Rational side(0);
    for (int axis = 0; axis < 3; ++axis)
      side += Rational(normal[axis]) * (Rational(light[axis]) - Rational(a[axis], 1 << f));
    on_plane += side == 0;
    EXPECT_EQ(facet::turns_away(info, light, f), side <= 0);
    EXPECT_EQ(facet::find_blocking({info}, light, f).front(), side <= 0);
    info.is_crowded = true;
    EXPECT_TRUE(facet::find_blocking({info}, light, f).front());
  }
  EXPECT_GT(on_plane, 5);
}

}  // namespace
}  // namespace rc2::golden
