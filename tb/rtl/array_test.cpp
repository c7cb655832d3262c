// The whole array against the other two machines: the same job on RTL, cycle model and golden model
// gives the same voxels, owners and target counts; and RTL and cycle model take the same cycles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <map>
#include <memory>
#include <string>

#include "sim/rtl_machine.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/facet/facet.h"
#include "sw/facet/layers.h"
#include "sw/golden/golden_machine.h"
#include "sw/scene/scene.h"
#include "tb/load/machine_check.h"
#include "tb/unit/random_packets.h"

namespace rc2 {
namespace {

constexpr std::array kRules{facet::Rule::armoured, facet::Rule::naive, facet::Rule::supercover,
                            facet::Rule::half, facet::Rule::blindee};

const Progress kQuiet = [](const char*, std::int64_t, double) {};

double real(Dice& dice, double low, double high) {
  return low + (high - low) * static_cast<double>(dice.roll(0, 1 << 20)) / (1 << 20);
}

/// The three machines of one build. The Verilated one is made once and used by every test.
struct Machines {
  explicit Machines(const std::string& name)
      : rtl(make_rtl_machine(name, {})), golden(rtl->config()), cycle(rtl->config()) {}
  std::array<Machine*, 3> all() { return {rtl.get(), &cycle, &golden}; }
  std::unique_ptr<Machine> rtl;
  golden::GoldenMachine golden;
  cycle::CycleMachine cycle;
};

Machines& machines_of(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Machines>> made;
  auto& machines = made[name];
  if (machines == nullptr) machines = std::make_unique<Machines>(name);
  return *machines;
}

Machines& machines_of(int n) { return machines_of("n" + std::to_string(n)); }

/// A Verilated machine, and how often a test draws lots for it.
struct Draws {
  const char* name;
  int count;
};

std::string name_of(const testing::TestParamInfo<Draws>& draws) { return draws.param.name; }

void load_everywhere(Machines& machines, const facet::PacketStream& packets) {
  machines.golden.load(packets, kQuiet);
  const LoadResult cycle = machines.cycle.load(packets, kQuiet);
  const LoadResult rtl = machines.rtl->load(packets, kQuiet);
  ASSERT_TRUE(machines.rtl->read_voxels() == machines.golden.read_voxels());
  ASSERT_TRUE(machines.cycle.read_voxels() == machines.golden.read_voxels());
  ASSERT_TRUE(machines.rtl->read_layers() == machines.golden.read_layers());
  ASSERT_TRUE(machines.cycle.read_layers() == machines.golden.read_layers());
  const LightMemory dark(machines.golden.read_voxels().size(), 0);
  for (Machine* machine : machines.all()) ASSERT_EQ(machine->read_light(), dark);
  ASSERT_EQ(rtl.cycles, cycle.cycles);
}

void light_everywhere(Machines& machines, const LightJob& job, std::int64_t* cycles = nullptr) {
  SCOPED_TRACE(testing::Message() << "light " << job.source.x << "," << job.source.y << ","
                                  << job.source.z << " L " << job.target_distance << " FA "
                                  << job.fa);
  const LightResult golden = machines.golden.light(job, kQuiet);
  const LightResult cycle = machines.cycle.light(job, kQuiet);
  const LightResult rtl = machines.rtl->light(job, kQuiet);
  ASSERT_EQ(machines.rtl->read_light(), machines.golden.read_light());
  ASSERT_EQ(machines.cycle.read_light(), machines.golden.read_light());
  // What would have escaped may have been skipped, and by the accurate rule what would have ended
  // in voxels that are not there to be lit.
  if (job.rule == LightRule::thesis) {
    ASSERT_EQ(cycle.targets.absorbed, golden.targets.absorbed);
  }
  ASSERT_EQ(cycle.targets.absorbed + cycle.targets.escaped + cycle.targets.skipped,
            golden.targets.absorbed + golden.targets.escaped);
  ASSERT_EQ(rtl.targets.absorbed, cycle.targets.absorbed);
  ASSERT_EQ(rtl.targets.escaped, cycle.targets.escaped);
  ASSERT_EQ(rtl.targets.skipped, cycle.targets.skipped);
  ASSERT_EQ(rtl.prepare_cycles, cycle.prepare_cycles);
  ASSERT_EQ(rtl.cycles, cycle.cycles);
  ASSERT_EQ(rtl.home_cycles, cycle.home_cycles);
  ASSERT_EQ(rtl.visits, cycle.visits);
  ASSERT_EQ(rtl.max_queue, cycle.max_queue);
  ASSERT_EQ(rtl.queue_history, cycle.queue_history);
  if (cycles != nullptr) *cycles = rtl.cycles;
}

/// A few random triangles and plates: large, small, slivers, edge-on and axis-aligned.
scene::Scene random_scene(Dice& dice, int n) {
  scene::Scene scene;
  scene.materials.emplace_back();
  const double side = n - 1;
  const int polygons = pick(dice, 0, 8);
  for (int i = 0; i < polygons; ++i) {
    glm::dvec3 corner(real(dice, 0, side), real(dice, 0, side), real(dice, 0, side));
    if (dice.chance(30)) corner = glm::round(corner * 2.0) * 0.5;
    const double reach = dice.chance(50) ? side : 2.0;
    const auto edge = [&] {
      glm::dvec3 e(real(dice, -reach, reach), real(dice, -reach, reach), real(dice, -reach, reach));
      if (dice.chance(30)) e[pick(dice, 0, 2)] = 0;
      if (dice.chance(20)) e *= 0.02;
      return e;
    };
    const auto inside = [&](glm::dvec3 p) { return glm::clamp(p, 0.0, side); };
    const glm::dvec3 e1 = edge();
    const glm::dvec3 e2 = edge();
    scene.add({inside(corner), inside(corner + e1), inside(corner + e2)}, 0);
  }
  return scene;
}

/// A free voxel: anywhere, in a corner, or beside a surface. False if the cube is full.
bool pick_source(Dice& dice, int n, const VoxelMemory& voxels, glm::ivec3& source) {
  const auto free = [&](glm::ivec3 p) {
    return std::none_of(voxels.begin(), voxels.end(),
                        [&](const VoxelRecord& v) { return v.at == p; });
  };
  const int kind = pick(dice, 0, 2);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    glm::ivec3 p(pick(dice, 0, n - 1), pick(dice, 0, n - 1), pick(dice, 0, n - 1));
    if (kind == 1 && attempt < 8) p = glm::ivec3(p.x % 2, p.y % 2, p.z % 2) * (n - 1);
    if (kind == 2 && !voxels.empty() && attempt < 100) {
      p = voxels[static_cast<std::size_t>(pick(dice, 0, static_cast<int>(voxels.size()) - 1))].at;
      p[pick(dice, 0, 2)] += dice.chance(50) ? 1 : -1;
      p = glm::clamp(p, 0, n - 1);
    }
    if (!free(p)) continue;
    source = p;
    return true;
  }
  return false;
}

class RandomScenes : public testing::TestWithParam<Draws> {};

TEST_P(RandomScenes, AgreeOnAllThreeMachines) {
  const auto [name, scenes] = GetParam();
  Machines& machines = machines_of(name);
  const int n = machines.rtl->config().n;
  Dice dice(static_cast<std::uint64_t>(n));
  for (int i = 0; i < scenes; ++i) {
    SCOPED_TRACE("scene " + std::to_string(i));
    const int f = pick(dice, 0, machines.rtl->config().fraction_bits);
    const auto rule = kRules[static_cast<std::size_t>(pick(dice, 0, 4))];
    const auto facets = facet::build_facets(random_scene(dice, n), n, f, rule);
    ASSERT_NO_FATAL_FAILURE(load_everywhere(machines, facets.packets));
    glm::ivec3 source;
    for (int light = 0; light < 2; ++light) {
      if (!pick_source(dice, n, machines.golden.read_voxels(), source)) continue;
      const int fa = dice.chance(30) ? 1 : pick(dice, 1, 32);
      const LightJob job{source, pick(dice, 1, 4 * n), fa};
      std::int64_t first = 0;
      ASSERT_NO_FATAL_FAILURE(light_everywhere(machines, job, &first));
      if (light == 0) continue;
      std::int64_t again = 0;
      ASSERT_NO_FATAL_FAILURE(light_everywhere(machines, job, &again));
      ASSERT_EQ(again, first) << "the same light takes other cycles after another light";
    }
  }
}

// As it would be in silicon: lit or not, at the same time.
TEST(WithoutCounts, VoxelsAreLitWhereTargetsArrive) {
  Machines& machines = machines_of("lit_n8");
  ASSERT_FALSE(machines.rtl->config().counts);
  Dice dice(8);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("scene " + std::to_string(i));
    const auto facets = facet::build_facets(random_scene(dice, 8), 8, 4, facet::Rule::armoured);
    ASSERT_NO_FATAL_FAILURE(load_everywhere(machines, facets.packets));
    glm::ivec3 source;
    if (!pick_source(dice, 8, machines.golden.read_voxels(), source)) continue;
    const LightJob job{source, pick(dice, 7, 32), pick(dice, 1, 32)};
    const LightResult cycle = machines.cycle.light(job, kQuiet);
    ASSERT_EQ(machines.rtl->light(job, kQuiet).cycles, cycle.cycles);
    LightMemory lit = machines.cycle.read_light();
    for (std::uint32_t& targets : lit) targets = targets != 0 ? 1 : 0;
    ASSERT_EQ(machines.rtl->read_light(), lit);
  }
}

class RandomFacets : public testing::TestWithParam<std::pair<int, std::size_t>> {};

// The exact oracle of tb/load, not the golden machine, has the last word here.
TEST_P(RandomFacets, FillWhatTheOracleSays) {
  const auto [n, wanted] = GetParam();
  Machines& machines = machines_of(n);
  std::size_t facets = 0;
  for (std::int64_t number = 0; facets < wanted; ++number) {
    Dice dice(static_cast<std::uint64_t>(100000LL * n + number));
    const int f = static_cast<int>(dice.roll(0, machines.rtl->config().fraction_bits));
    const facet::Cube cube{n, f};
    const auto borders = facet::draw_apart(7, number, cube, 24, n < 8 ? 0 : 2);
    const auto rule = kRules[static_cast<std::size_t>(number) % kRules.size()];
    ASSERT_NO_THROW(facet::check_machines({machines.rtl.get(), &machines.cycle, &machines.golden},
                                          borders, cube, rule))
        << "load " << number;
    facets += borders.size();
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, RandomFacets,
                         testing::Values(std::pair{4, 8000}, std::pair{5, 8000}, std::pair{8, 4000},
                                         std::pair{16, 300}),
                         [](const auto& size) { return "n" + std::to_string(size.param.first); });

class RandomPackets : public testing::TestWithParam<Draws> {};

// Every kind of surface and every layer, in all mixtures; one light in four by the thesis's rule.
TEST_P(RandomPackets, LoadAndLightTheSameOnAllThreeMachines) {
  const auto [name, rounds] = GetParam();
  Machines& machines = machines_of(name);
  const int n = machines.rtl->config().n;
  Dice dice(static_cast<std::uint64_t>(n));
  const int f = machines.rtl->config().fraction_bits;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const std::int64_t scale =
        round % 2 == 0 ? 4 : std::int64_t{1} << (2 * (coordinate_bits(n) + f));
    const auto packets = random_layers(dice, n, pick(dice, 1, 25), scale, f);
    ASSERT_NO_FATAL_FAILURE(load_everywhere(machines, packets));
    for (int light = 0; light < 4; ++light) {
      glm::ivec3 source;
      if (!pick_source(dice, n, machines.golden.read_voxels(), source)) continue;
      const LightRule rule = light == 1 ? LightRule::thesis : LightRule::accurate;
      ASSERT_NO_FATAL_FAILURE(
          light_everywhere(machines, {source, pick(dice, 1, 4 * n), pick(dice, 1, 32), rule}));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Machines, RandomPackets,
                         testing::Values(Draws{"n4", 60}, Draws{"n5", 60}, Draws{"n8", 60},
                                         Draws{"n16", 15}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(Machines, RandomScenes,
                         testing::Values(Draws{"n4", 200}, Draws{"whole_n4", 100}, Draws{"n5", 150},
                                         Draws{"n8", 150}, Draws{"n16", 15}, Draws{"thesis_n4", 80},
                                         Draws{"thesis_n5", 60}, Draws{"thesis_n8", 80}),
                         name_of);

class Layers : public testing::TestWithParam<const char*> {};

// Every second layer is full, so a column has as many runs of stops as there can be: more than a
// cell keeps at hand from n = 13 on.
TEST_P(Layers, StopLightInEveryColumn) {
  Machines& machines = machines_of(GetParam());
  const int n = machines.rtl->config().n;
  Dice dice(static_cast<std::uint64_t>(n));
  for (int first = 0; first < 2; ++first) {
    facet::PacketStream packets;
    for (int z = first; z < n; z += 2)
      add_packet(packets, static_cast<std::uint32_t>(z), {0, 0, z}, {n - 1, n - 1, z});
    ASSERT_NO_FATAL_FAILURE(load_everywhere(machines, packets));
    for (int light = 0; light < 6; ++light) {
      glm::ivec3 source;
      ASSERT_TRUE(pick_source(dice, n, machines.golden.read_voxels(), source));
      ASSERT_NO_FATAL_FAILURE(
          light_everywhere(machines, {source, pick(dice, n - 1, 4 * n), pick(dice, 1, 32)}));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Machines, Layers,
                         testing::Values("n4", "n5", "n8", "n16", "thesis_n4", "thesis_n5"),
                         [](const auto& name) { return std::string(name.param); });

class Specks : public testing::TestWithParam<Draws> {};

// A few voxels far apart, a light in a corner: what the cells come to know of the scene decides how
// far it goes.
TEST_P(Specks, EndLightThatHasNothingMoreToMeet) {
  const auto [name, count] = GetParam();
  Machines& machines = machines_of(name);
  const int n = machines.rtl->config().n;
  Dice dice(static_cast<std::uint64_t>(n));
  const auto corner = [&] { return (n - 1) * pick(dice, 0, 1); };
  for (int round = 0; round < count; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const glm::ivec3 source(corner(), corner(), corner());
    facet::PacketStream packets;
    for (int i = pick(dice, 1, 3); i > 0; --i) {
      const glm::ivec3 at(pick(dice, 0, n - 1), pick(dice, 0, n - 1), pick(dice, 0, n - 1));
      if (at != source) add_packet(packets, static_cast<std::uint32_t>(i), at, at);
    }
    ASSERT_NO_FATAL_FAILURE(load_everywhere(machines, packets));
    ASSERT_NO_FATAL_FAILURE(light_everywhere(machines, {source, pick(dice, n - 1, 2 * n), 8}));
  }
}

INSTANTIATE_TEST_SUITE_P(Machines, Specks,
                         testing::Values(Draws{"n4", 60}, Draws{"n5", 200}, Draws{"n8", 100},
                                         Draws{"n16", 8}),
                         name_of);

class RealScenes : public testing::TestWithParam<const char*> {};

TEST_P(RealScenes, AgreeOnAllThreeMachines) {
  const scene::Scene file = scene::read_file(GetParam());
  for (const char* name : {"n16", "thesis_n8"}) {
    SCOPED_TRACE(name);
    Machines& machines = machines_of(name);
    const int n = machines.rtl->config().n;
    scene::Scene scene = file;
    scene::fit_to_cube(scene, n);
    const auto facets = facet::build_facets(scene, n, 4, facet::Rule::armoured);
    ASSERT_GT(facets.packets.heads.size(), 0U);
    ASSERT_NO_FATAL_FAILURE(load_everywhere(machines, facets.packets));
    Dice dice(6);
    glm::ivec3 source;
    for (const auto& [distance, fa] : {std::pair{2 * n, 16}, std::pair{n - 1, 1}}) {
      ASSERT_TRUE(pick_source(dice, n, machines.golden.read_voxels(), source));
      ASSERT_NO_FATAL_FAILURE(light_everywhere(machines, {source, distance, fa}));
    }
    if (machines.rtl->config().mode == LightMode::thesis) continue;
    ASSERT_NO_FATAL_FAILURE(load_everywhere(machines, facet::build_layers(scene, n, 4).packets));
    for (int light = 0; light < 3; ++light) {
      ASSERT_TRUE(pick_source(dice, n, machines.golden.read_voxels(), source));
      ASSERT_NO_FATAL_FAILURE(light_everywhere(machines, {source, 2 * n, 8, LightRule::accurate}));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealScenes,
                         testing::Values(RC2_SOURCE_DIR "/sw/scene/room.dae",
                                         "/usr/share/assimp/models/Collada/duck.dae",
                                         "/usr/share/assimp/models/OBJ/spider.obj",
                                         "/usr/share/assimp/models/OBJ/WusonOBJ.obj",
                                         "/usr/share/assimp/models/STL/3DSMaxExport.STL"),
                         [](const auto& scene) {
                           std::string name(scene.param);
                           name = name.substr(name.find_last_of('/') + 1);
                           name.resize(name.find('.'));
                           return name;
                         });

}  // namespace
}  // namespace rc2
