#include "sim/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sw/machine/checks.h"
#include "sw/scene/scene.h"

namespace rc2 {
namespace {

constexpr int kMaxQueue = 1 << 30;

template <typename Number>
void check_range(const char* option, Number value, Number lowest, Number highest) {
  if (value < lowest || value > highest) {
    throw Error(
        fmt::format("{} {} is out of range; choose {} to {}", option, value, lowest, highest));
  }
}

void complete_seed(std::string& scene, std::int64_t seed) {
  const bool takes_seed = scene.rfind("shells:", 0) == 0 || scene.rfind("dust:", 0) == 0;
  if (takes_seed && std::count(scene.begin(), scene.end(), ':') == 1) {
    scene += fmt::format(":{}", seed);
  }
}

}  // namespace

bool SceneOptions::fitted() const {
  return fit.empty() ? !scene::is_generated_name(scene) : fit == "cube";
}

LightRule LightOptions::rule_of_light() const {
  if (!light_rule.empty()) return parse_light_rule(light_rule);
  return light_mode() == LightMode::fast && rule == "armoured" ? LightRule::accurate
                                                               : LightRule::thesis;
}

void declare_scene_options(Command& command, SceneOptions& options) {
  command
      .option("SCENE", options.scene,
              "A file that Assimp reads, or a generated scene: empty, room, gallery, ball:R, "
              "shells:PERCENT[:SEED], dust:PERCENT[:SEED]")
      .required();
  command.option("--n", options.n, "Cells per side and voxels per column, 2 to 1024");
  command
      .option("--fit", options.fit,
              "cube: scale the scene to the voxels 1 .. n-2; none: take it as voxel "
              "coordinates (default: cube for files, none for generated scenes)")
      .one_of({"cube", "none"});
  command.option("--fraction-bits", options.fraction_bits,
                 "Vertices are multiples of 2^-f voxel, f from 0 to 8");
  command.option("--rule", options.rule,
                 "Voxels of a facet: armoured, naive, supercover, half or blindee");
  command.option("--feeders", options.feeders,
                 "Row feeders: words that the host port takes per cycle, a power of two "
                 "(default: 1 for n < 8, then n / 4, at most 16)");
  command.option("--seed", options.seed, "Seed of shells:PERCENT and dust:PERCENT named without");
}

void declare_machine_options(Command& command, SceneOptions& options, const std::string& machine) {
  options.machine = machine;
  command.option("--machine", options.machine, "The machine").one_of({"golden", "cycle", "rtl"});
  command.option("--dump", options.dump, "Write the memories to this CSV file").type("FILE.csv");
}

void declare_lights(Command& command, std::vector<std::string>& lights) {
  command
      .option("--light", lights,
              "x,y,z[,r,g,b]: a light at a voxel, colour 1,1,1 if not given; may be repeated "
              "(default: the scene's lights; one in the upper front left if it has none)")
      .repeated();
}

void declare_light_options(Command& command, LightOptions& options) {
  declare_scene_options(command, options);
  declare_lights(command, options.lights);
  command
      .option("--light-rule", options.light_rule,
              "Where light ends; thesis: in every occupied voxel; accurate: where facets turn "
              "away from it, inside solids and behind sheets (default: accurate in fast mode "
              "with --rule armoured, else thesis)")
      .one_of({"thesis", "accurate"});
  command.option("--target-distance", options.target_distance,
                 "Distance L of the virtual faces that light aims at, in voxels (default 2n)");
  command
      .option("--mode", options.mode,
              "How light spreads: fast, in lanes; thesis, voxel by voxel (4.4). What it reaches "
              "is the same")
      .one_of({"fast", "thesis"});
  command
      .option("--skip", options.skip,
              "In fast mode, whether light that can meet nothing ends early (off: not with "
              "--machine rtl)")
      .one_of({"on", "off"});
  command.option("--fa", options.fa, "Beams that a cell has room for");
}

void declare_run_options(Command& command, RunOptions& options) {
  declare_light_options(command, options);
  declare_machine_options(command, options, "cycle");
  command.option("--out", options.out, "Folder of picture.png, picture.exr and report.json")
      .type("DIR");
  command
      .option("--volume", options.volume,
              "Write voxels, owners and light to this OpenVDB file, for Blender or ParaView")
      .type("FILE.vdb");
  const Option waves = command
                           .option("--waves", options.waves,
                                   "Write a waveform to this FST file (--machine rtl only)")
                           .type("FILE.fst");
  command.option("--waves-from", options.waves_from, "First clock cycle of the waveform")
      .needs(waves);
  command.option("--waves-cycles", options.waves_cycles, "Clock cycles in the waveform")
      .needs(waves);
}

void check_options(SceneOptions& options) {
  check_range("--n", options.n, 2, kMaxSide);
  check_range("--fraction-bits", options.fraction_bits, 0, kMaxFractionBits);
  // Signed here, because the command line would take -1 for a huge unsigned number.
  check_range<std::int64_t>("--seed", options.seed, 0, std::numeric_limits<std::int64_t>::max());
  check_feeders("--feeders", options.feeder_count(), options.n);
  facet::parse_rule(options.rule);
  complete_seed(options.scene, options.seed);
}

void check_options(LightOptions& options) {
  check_options(static_cast<SceneOptions&>(options));
  check_range("--target-distance", options.distance(), 1, kMaxDistance);
  check_range("--fa", options.fa, 1, kMaxQueue);
  if (options.light_rule == "accurate" && options.light_mode() == LightMode::thesis) {
    throw Error(
        "--light-rule accurate: in thesis mode light ends as in the thesis; leave out --mode or "
        "--light-rule");
  }
}

void check_options(RunOptions& options) {
  check_options(static_cast<LightOptions&>(options));
  constexpr std::int64_t kLongest = 1'000'000'000'000;
  check_range<std::int64_t>("--waves-from", options.waves_from, 0, kLongest);
  check_range<std::int64_t>("--waves-cycles", options.waves_cycles, 1, kLongest);
  if (!options.waves.empty() && options.machine != "rtl") {
    throw Error(fmt::format("--waves {}: the {} model has no signals to show; use --machine rtl",
                            options.waves, options.machine));
  }
}

}  // namespace rc2
