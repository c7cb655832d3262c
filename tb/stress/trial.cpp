#include "tb/stress/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <memory>

#include "sw/cycle/cycle_machine.h"
#include "sw/facet/layers.h"
#include "sw/golden/golden_machine.h"
#include "sw/machine/checks.h"
#include "sw/report/laws.h"
#include "tb/load/machine_check.h"
#include "tb/stress/bodies.h"
#include "tb/stress/light_oracle.h"
#include "tb/stress/sources.h"

namespace rc2::stress {
namespace {

using facet::Difference;
using facet::Rule;

constexpr std::array kRules{Rule::armoured, Rule::naive, Rule::supercover, Rule::half,
                            Rule::blindee};
// Golden follows every ray; of more it would take all the time.
constexpr std::int64_t kMostGoldenTargets = 1'000'000;

std::vector<Named> make_machines(const Cube& cube, const std::vector<Named>& more, Dice& dice) {
  MachineConfig config{cube.n, cube.fraction_bits, kMaxDistance, 16,
                       facet::random_feeders(cube.n, dice)};
  std::vector<Named> machines;
  machines.push_back({"golden", std::make_shared<golden::GoldenMachine>(config)});
  machines.push_back({"cycle, fast", std::make_shared<cycle::CycleMachine>(config)});
  config.mode = LightMode::thesis;
  machines.push_back({"cycle, thesis", std::make_shared<cycle::CycleMachine>(config)});
  machines.insert(machines.end(), more.begin(), more.end());
  return machines;
}

class Trial {
 public:
  Trial(const Attack& attack, const Cube& cube, std::uint64_t seed, const std::vector<Named>& more,
        Findings& findings)
      : is_closed_(attack.is_closed),
        cube_(cube),
        dice_(seed),
        machines_(make_machines(cube, more, dice_)),
        findings_(findings),
        attack_(findings.at("attack", attack.name)) {
    bodies_ = attack.draw(cube, dice_);
    for (const Body& body : bodies_) borders_.insert(borders_.end(), body.begin(), body.end());
  }

  void run() {
    ++attack_.trials;
    check_voxels();
    facets_ = facet::build_layers(facet::scene_of(borders_, cube_), cube_.n, cube_.fraction_bits);
    for (const Named& named : machines_) check_layers(*named.machine);
    const LightOracle oracle(cube_.n, voxels_, layers_, facets_.packets);
    if (is_closed_) check_inside(oracle);
    for (const auto& [place, source] : choose_sources(oracle, cube_.n, dice_)) {
      for (int i = 0; i < 3; ++i) check_light(oracle, place, source, draw_distance(cube_.n, dice_));
    }
  }

 private:
  void check_voxels() {
    const auto count = [](std::size_t size) { return static_cast<std::int64_t>(size); };
    std::vector<Border> with_area;
    std::copy_if(borders_.begin(), borders_.end(), std::back_inserter(with_area), facet::has_area);
    const Rule rule = kRules[static_cast<std::size_t>(dice_.roll(0, kRules.size() - 1))];
    const facet::FacetCounts counts =
        build_facets(facet::scene_of(borders_, cube_), cube_.n, cube_.fraction_bits, rule).counts;
    if (counts.read != count(borders_.size()) ||
        counts.degenerate != counts.read - count(with_area.size()) || counts.triangulated != 0 ||
        counts.loaded + counts.degenerate + counts.outside != counts.read)
      throw Difference("the host lost a facet, or is wrong about its area");
    attack_.facets += counts.read;
    attack_.without_area += counts.degenerate;
    // Modes load alike.
    std::vector<Machine*> loaded;
    for (const Named& named : machines_)
      if (named.machine->config().mode == LightMode::fast) loaded.push_back(named.machine.get());
    check_machines(loaded, with_area, cube_, rule);
    const std::int64_t voxels = count(loaded.size()) * cube_.n * cube_.n * cube_.n;
    attack_.voxels += voxels;
    Tally& of_rule = findings_.at("voxels by rule", to_string(rule));
    ++of_rule.trials;
    of_rule.facets += counts.read;
    of_rule.voxels += voxels;
  }

  void check_layers(Machine& machine) {
    machine.load(facets_.packets, {});
    const VoxelMemory voxels = machine.read_voxels();
    const LayerMemory layers = machine.read_layers();
    report::check_voxels(voxels, cube_.n, facets_.facets.size());
    if (voxels_.empty()) {
      voxels_ = voxels;
      layers_ = layers;
    }
    if (!(voxels == voxels_)) throw Difference("two machines differ in a voxel of the armour");
    if (!(layers == layers_)) throw Difference("two machines differ in a layer");
    attack_.voxels += std::int64_t{cube_.n} * cube_.n * cube_.n;
  }

  void check_inside(const LightOracle& oracle) {
    std::string wrong;
    glm::ivec3 at;
    for (at.z = 0; at.z < cube_.n; ++at.z)
      for (at.y = 0; at.y < cube_.n; ++at.y)
        for (at.x = 0; at.x < cube_.n; ++at.x)
          if (is_in_a_body(bodies_, cube_, at) != oracle.is_inside(at))
            wrong = fmt::format("voxel ({}, {}, {}) is {}inside a body", at.x, at.y, at.z,
                                oracle.is_inside(at) ? "not " : "");
    // The host takes bodies that share a facet for one, and what is in both for its outside
    // (docs/stress.md).
    const bool is_limit = share_a_facet(bodies_);
    Tally& tally = findings_.at("inside of bodies",
                                is_limit ? "some share a facet" : "apart, crossing, in each other");
    ++tally.trials;
    tally.voxels += std::int64_t{cube_.n} * cube_.n * cube_.n;
    tally.differences += wrong.empty() ? 0 : 1;
    if (!wrong.empty() && !is_limit) throw Difference(wrong);
  }

  void check_light(const LightOracle& oracle, const char* place, const glm::ivec3& source,
                   const std::pair<std::string, int>& distance) {
    const auto fa = static_cast<int>(dice_.roll_size(16));
    for (const LightRule rule : {LightRule::thesis, LightRule::accurate}) {
      const LightJob job{source, distance.second, fa, rule};
      const ExpectedLight expected = oracle.light(job);
      if (expected.targets.total != total_targets(job.target_distance))
        throw Difference("the oracle lost a target");
      for (const Named& named : machines_) {
        Machine& machine = *named.machine;
        const bool is_golden = &named == machines_.data();
        if (rule == LightRule::accurate && !machine.config().accurate_light()) continue;
        if (is_golden && expected.targets.total > kMostGoldenTargets) continue;
        const bool is_refused = !lights_as_expected(machine, job, expected, is_golden);
        const std::string machine_and_rule = fmt::format("{}, {}", named.name, to_string(rule));
        for (Tally* tally :
             {&attack_, &findings_.at("light from", place), &findings_.at("L", distance.first),
              &findings_.at("machine and rule of light", machine_and_rule)}) {
          tally->refused += is_refused ? 1 : 0;
          tally->lights += is_refused ? 0 : 1;
          tally->targets += is_refused ? 0 : expected.targets.total;
        }
      }
    }
  }

  // False if the machine says that it cannot do the light.
  static bool lights_as_expected(Machine& machine, const LightJob& job,
                                 const ExpectedLight& expected, bool is_golden) {
    LightResult result;
    try {
      result = machine.light(job, {});
    } catch (const Error&) {
      return false;
    }
    const LightMemory arrived = machine.read_light();
    report::check_light(result, arrived, job, expected.arrived.size());
    if (arrived != expected.arrived)
      throw Difference("another number of targets arrived at some voxel");
    // What can light nothing more may be skipped before it ends in a voxel.
    const std::int64_t absorbed = result.targets.absorbed, wanted = expected.targets.absorbed;
    if (absorbed > wanted || absorbed + result.targets.skipped < wanted)
      throw Difference("another number of targets was absorbed");
    if (is_golden && result.visits != expected.visits)
      throw Difference("rays looked at another number of voxels");
    return true;
  }

  bool is_closed_;
  Cube cube_;
  Dice dice_;
  std::vector<Named> machines_;
  Findings& findings_;
  Tally& attack_;
  std::vector<Body> bodies_;
  std::vector<Border> borders_;
  facet::FacetSet facets_;
  VoxelMemory voxels_;
  LayerMemory layers_;
};

}  // namespace

void run_trial(const Attack& attack, const Cube& cube, std::uint64_t seed,
               const std::vector<Named>& more, Findings& findings) {
  Trial(attack, cube, seed, more, findings).run();
}

}  // namespace rc2::stress
