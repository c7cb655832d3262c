// Chapter 4: how long light takes, by scene, size, source, L, depth of the queues and mode.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "sim/commands.h"
#include "sim/job.h"
#include "sim/light_sources.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sim/timed_load.h"
#include "sw/base/replace_file.h"
#include "sw/cycle/cycle_machine.h"

namespace rc2 {
namespace {

struct DiffusionOptions {
  std::vector<std::string> scenes;
  std::vector<int> sides = {16, 32, 64};
  std::vector<int> queues = {8};
  std::vector<std::string> modes = {"thesis", "fast"};
  std::vector<std::string> skips = {"on"};
  std::vector<std::string> rules = {"thesis"};
  std::string out;
};

struct Measured {
  std::string scene;
  int n;
  LightMode mode;
  bool skips;
  const char* source;
  LightJob job;
  LightResult light;
  double seconds;  ///< of processor time

  int farthest() const { return cycle::farthest_face(job.source, n); }
  std::int64_t bound() const { return std::int64_t{hop_stages(mode)} * (farthest() + 1); }
};

void measure(const std::string& scene, int n, LightMode mode, bool skips,
             const facet::PacketStream& packets, const DiffusionOptions& options, ProgressBar& bar,
             std::vector<Measured>& all) {
  const std::string name =
      scene::is_generated_name(scene) ? scene : std::filesystem::path(scene).filename().string();
  const std::string title = fmt::format("{}, n = {}, {}", name, n, to_string(mode));
  MachineConfig config;
  config.n = n;
  config.max_distance = 2 * n;
  config.max_fa = *std::max_element(options.queues.begin(), options.queues.end());
  config.feeders = default_feeders(n);
  config.mode = mode;
  config.skips = skips;
  cycle::CycleMachine machine(config);
  machine.load(packets, bar.step(title + ", loading"));
  for (const LightSource& source : choose_sources(name, machine.read_voxels(), n)) {
    for (const int distance : {n - 1, 2 * n}) {
      for (const int fa : options.queues) {
        for (const std::string& rule : options.rules) {
          const LightJob job{source.voxel, distance, fa, parse_light_rule(rule)};
          if (job.rule == LightRule::accurate && mode == LightMode::thesis) continue;
          Best watch;
          const LightResult light = watch.time([&] { return machine.light(job, bar.step(title)); });
          all.push_back({name, n, mode, skips, source.name, job, light, watch.seconds()});
        }
      }
    }
  }
}

void print(const std::vector<Measured>& all) {
  fmt::print(
      "Light on the cycle model. The bound: P cycles for each step to the farthest face, and for\n"
      "the step there. The fast mode always takes them, the thesis's ends when no beam is left.\n"
      "Where a source would stand in a voxel of the scene, the nearest free one is taken.\n\n"
      "{:<20}{:>5}  {:<8}{:>5}{:>4}  {:<7} {:<9} {:<5}{:>8}{:>9}{:>7}{:>8}{:>13}{:>12}{:>9}\n",
      "scene", "n", "source", "L", "FA", "mode", "rule", "skip", "prepare", "T", "bound", "excess",
      "visits", "merged", "deepest");
  for (const Measured& row : all) {
    fmt::print(
        "{:<20}{:>5}  {:<8}{:>5}{:>4}  {:<7} {:<9} {:<5}{:>8}{:>9}{:>7}{:>8}{:>13}{:>12}{:>9}\n",
        row.scene, row.n, row.source, row.job.target_distance, row.job.fa, to_string(row.mode),
        to_string(row.job.rule), row.skips ? "on" : "off", row.light.prepare_cycles,
        row.light.cycles, row.bound(), row.light.cycles - row.bound(), row.light.visits,
        row.light.merged, row.light.max_queue);
  }
}

std::string to_csv(const std::vector<Measured>& all) {
  std::string csv =
      "scene,n,source,x,y,z,L,fa,mode,rule,skip,P,kmax,prepare,T,bound,excess,visits,merged,"
      "deepest,"
      "seconds\n";
  for (const Measured& row : all) {
    const glm::ivec3 at = row.job.source;
    csv += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.6f}\n", row.scene, row.n,
        row.source, at.x, at.y, at.z, row.job.target_distance, row.job.fa, to_string(row.mode),
        to_string(row.job.rule), row.skips ? "on" : "off", hop_stages(row.mode), row.farthest(),
        row.light.prepare_cycles, row.light.cycles, row.bound(), row.light.cycles - row.bound(),
        row.light.visits, row.light.merged, row.light.max_queue, row.seconds);
  }
  return csv;
}

ExitCode measure_diffusion(const DiffusionOptions& options) {
  Outputs outputs;
  if (!options.out.empty()) outputs.add_file(options.out);
  ProgressBar bar;
  std::vector<Measured> all;
  const bool with_layers =
      std::find(options.rules.begin(), options.rules.end(), "accurate") != options.rules.end();
  for (const std::string& scene : options.scenes) {
    for (const int n : options.sides) {
      SceneOptions loaded;
      loaded.scene = scene;
      loaded.n = n;
      check_options(loaded);
      within_memory(n, [&] {
        const facet::PacketStream packets = prepare(loaded, with_layers).facets.packets;
        for (const std::string& mode : options.modes) {
          for (const std::string& skip : options.skips) {
            measure(loaded.scene, n, parse_light_mode(mode), skip == "on", packets, options, bar,
                    all);
          }
        }
      });
    }
  }
  bar.wipe();
  print(all);
  if (!options.out.empty()) replace_file(options.out, to_csv(all));
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_diffusion(Command& program) {
  auto options = std::make_shared<DiffusionOptions>();
  Command command = program.command(
      "diffusion",
      "Counts the cycles that light takes, from three sources, for L = n-1 and 2n (chapter 4)");
  command.option("SCENE", options->scenes, "Files that Assimp reads, or generated scenes")
      .required();
  command
      .option("--n", options->sides,
              fmt::format("Cells per side and voxels per column, 2 to {}", kMaxSide))
      .list()
      .within(2, kMaxSide);
  command.option("--fa", options->queues, "Beams that a cell has room for, 1 to 64")
      .list()
      .within(1, 64);
  command.option("--mode", options->modes, "How light spreads: thesis, fast")
      .list()
      .one_of({"thesis", "fast"});
  command
      .option("--skip", options->skips,
              "In fast mode, whether light that can meet nothing ends early: on, off")
      .list()
      .one_of({"on", "off"});
  command
      .option("--light-rule", options->rules, "Where light ends: thesis, accurate (fast mode only)")
      .list()
      .one_of({"thesis", "accurate"});
  command.option("--out", options->out, "Write the table to this CSV file").type("FILE.csv");
  command.run([options] { return measure_diffusion(*options); });
}

}  // namespace rc2
