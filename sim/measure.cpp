// The benchmark's measurements of the machine: run time, work and error of every combination asked
// for, in one table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/bench_row.h"
#include "sim/commands.h"
#include "sim/light_stage.h"
#include "sim/machines.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sim/stage_command.h"
#include "sim/timed_load.h"
#include "sw/base/replace_file.h"
#include "sw/report/laws.h"

namespace rc2 {
namespace {

struct MeasureOptions : StageOptions {
  std::string rule = "armoured";
  std::vector<std::string> machines = {"golden", "cycle"};
  std::vector<std::string> modes = {"fast"};
  std::vector<std::string> light_rules = {"thesis", "accurate"};
  std::vector<double> reaches = {2};
  std::vector<int> queues = {8};
};

class Measure {
 public:
  Measure(const MeasureOptions& options, ProgressBar& bar)
      : options_(options),
        bar_(bar),
        stage_(options.scene, options.n, options.fraction_bits, facet::parse_rule(options.rule),
               bar.step("loading")),
        picture_(stage_) {
    std::vector<glm::ivec3> places;
    for (const VoxelRecord& voxel : stage_.voxels) places.push_back(voxel.at);
    voxel_error_ = voxel_error(stage_, places);
    for (int i = 0; i < options.lights; ++i) {
      const glm::ivec3 at = stage_.light(i);
      lights_.push_back({at, stage_.judge(at), stage_.away(at)});
    }
  }

  void run() {
    for (const std::string& name : options_.machines) {
      for (const std::string& mode : options_.modes) {
        // Golden has no notion of how light spreads.
        if (name == "golden" && mode != options_.modes.front()) continue;
        run_machine(name, mode);
      }
    }
  }

  const std::vector<BenchRow>& rows() const { return rows_; }
  std::int64_t skipped() const { return skipped_; }

 private:
  struct Light {
    glm::ivec3 at;
    std::vector<truth::Verdict> verdicts;
    std::vector<bool> away;
  };

  int distance_of(double reach) const {
    return std::max(1, static_cast<int>(std::lround(reach * stage_.n)));
  }

  void run_machine(const std::string& name, const std::string& mode) {
    MachineConfig needs;
    needs.n = stage_.n;
    needs.fraction_bits = stage_.fraction_bits;
    needs.max_distance =
        distance_of(*std::max_element(options_.reaches.begin(), options_.reaches.end()));
    needs.max_fa = *std::max_element(options_.queues.begin(), options_.queues.end());
    needs.feeders = default_feeders(stage_.n);
    needs.mode = parse_light_mode(mode);
    const auto machine = make_machine(name, needs);

    BenchRow row;
    row.scene = stage_.title;
    row.method = name;
    row.rule = options_.rule;
    row.mode = name == "golden" ? "" : mode;
    row.n = stage_.n;
    row.fraction_bits = stage_.fraction_bits;
    row.facets = static_cast<std::int64_t>(stage_.facets.facets.size());
    row.voxels = voxel_error_;
    row.prepare_seconds = stage_.packet_seconds;
    Best watch;
    const LoadResult load = watch.time(
        [&] { return machine->load(stage_.facets.packets, bar_.step(name + ", loading")); });
    if (!(machine->read_voxels() == stage_.voxels))
      throw std::logic_error(fmt::format("the {} machine's voxels are not golden's", name));
    row.load_seconds = watch.seconds();
    if (name != "golden") row.load_cycles = load.cycles;
    for (const Light& light : lights_) {
      row.light = static_cast<int>(&light - lights_.data());
      row.at = light.at;
      for (const std::string& rule : options_.light_rules) {
        row.light_rule = rule;
        for (const double reach : options_.reaches) {
          row.distance = distance_of(reach);
          // A queue's depth means nothing to golden.
          const auto queues = name == "golden" ? std::vector<int>{1} : options_.queues;
          for (const int fa : queues) {
            row.fa = name == "golden" ? std::optional<int>() : fa;
            run_light(*machine, light, {light.at, *row.distance, fa, parse_light_rule(rule)}, row);
          }
        }
      }
    }
  }

  void run_light(Machine& machine, const Light& light, const LightJob& job, BenchRow row) {
    const bool has_layers = options_.rule == "armoured";
    if (job.rule == LightRule::accurate && !(machine.config().accurate_light() && has_layers)) {
      ++skipped_;
      return;
    }
    Best watch;
    const LightResult result =
        watch.time([&] { return machine.light(job, bar_.step(row.method + ", light")); });
    const LightMemory arrived = machine.read_light();
    report::check_light(result, arrived, job, stage_.voxels.size());
    row.light_seconds = watch.seconds();
    row.visits = result.visits;
    if (row.method != "golden") {
      row.light_cycles = result.prepare_cycles + result.cycles;
      row.merged = result.merged;
      row.deepest = result.max_queue;
    }
    row.errors.emplace();
    for (std::size_t i = 0; i < kPopulations.size(); ++i)
      (*row.errors)[i] = stage_.shown.compare(light.verdicts, kPopulations[i], arrived, light.away);
    row.picture = picture_.compare(light.at, arrived);
    rows_.push_back(row);
  }

  const MeasureOptions& options_;
  ProgressBar& bar_;
  LightStage stage_;
  PictureError picture_;
  VoxelError voxel_error_;
  std::vector<Light> lights_;
  std::vector<BenchRow> rows_;
  std::int64_t skipped_ = 0;
};

ExitCode measure(const MeasureOptions& options) {
  Outputs outputs;
  outputs.add_file(options.out);
  ProgressBar bar;
  Measure bench(options, bar);
  bench.run();
  bar.wipe();
  replace_file(options.out, to_csv(bench.rows()));
  fmt::print(
      "{} lights measured, {} skipped (no layers, or a machine that lacks the accurate rule)\n",
      bench.rows().size(), bench.skipped());
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_measure(CLI::App& program, ExitCode& exit_code) {
  auto options = std::make_shared<MeasureOptions>();
  auto* command = program.add_subcommand(
      "measure",
      "Run time beside error: loads and lights a scene in many ways, compares voxels, "
      "light and picture with the continuous scene (Embree)");
  declare_stage_options(*command, *options);
  command->add_option("--rule", options->rule, "Voxels of a facet, as for run")
      ->capture_default_str();
  command->add_option("--machine", options->machines, "Machines")
      ->delimiter(',')
      ->check(CLI::IsMember({"golden", "cycle", "rtl"}))
      ->capture_default_str();
  command->add_option("--mode", options->modes, "How light spreads")
      ->delimiter(',')
      ->check(CLI::IsMember({"fast", "thesis"}))
      ->capture_default_str();
  command->add_option("--light-rule", options->light_rules, "Rules of light")
      ->delimiter(',')
      ->check(CLI::IsMember({"thesis", "accurate"}))
      ->capture_default_str();
  command->add_option("--reach", options->reaches, "Distances L of the virtual faces, over n")
      ->delimiter(',')
      ->check(CLI::Range(0.1, 8.0))
      ->capture_default_str();
  command->add_option("--fa", options->queues, "Beams that a cell has room for")
      ->delimiter(',')
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->callback([options, &exit_code] {
    exit_code = within_memory(options->n, [&] { return measure(*options); });
  });
}

}  // namespace rc2
