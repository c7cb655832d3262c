#include "sim/bench_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim/light_stage.h"
#include "sim/machines.h"
#include "sim/timed_load.h"
#include "sw/report/laws.h"

namespace rc2 {
namespace {

class Measure {
 public:
  Measure(const MeasureOptions& options, ProgressBar& bar)
      : options_(options),
        bar_(bar),
        stage_(options.scene, options.n, options.fraction_bits, facet::parse_rule(options.rule),
               options.coefficient_bits, bar.step("loading")),
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
      // Golden has no notion of how light spreads.
      if (name == "golden") {
        run_machine(name, options_.modes.front(), false);
        continue;
      }
      for (const std::string& mode : options_.modes)
        for (const std::string& skip : options_.skips) run_machine(name, mode, skip == "on");
    }
  }

  const MeasuredRows& measured() const { return measured_; }

 private:
  struct Light {
    glm::ivec3 at;
    std::vector<truth::Verdict> verdicts;
    std::vector<bool> away;
  };

  int distance_of(double reach) const {
    return std::max(1, static_cast<int>(std::lround(reach * stage_.n)));
  }

  void run_machine(const std::string& name, const std::string& mode, bool skips) {
    MachineConfig needs;
    needs.n = stage_.n;
    needs.fraction_bits = stage_.fraction_bits;
    needs.max_distance =
        distance_of(*std::max_element(options_.reaches.begin(), options_.reaches.end()));
    needs.max_fa = *std::max_element(options_.queues.begin(), options_.queues.end());
    needs.feeders = default_feeders(stage_.n);
    needs.mode = parse_light_mode(mode);
    needs.skips = skips;
    const auto machine = make_machine(name, needs);

    BenchRow row;
    row.scene = stage_.title;
    row.method = name;
    row.rule = options_.rule;
    if (name != "golden") {
      row.mode = mode;
      row.skips = skips;
    }
    row.n = stage_.n;
    row.fraction_bits = stage_.fraction_bits;
    row.coefficient_bits = options_.coefficient_bits;
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
      ++measured_.skipped;
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
    measured_.rows.push_back(row);
  }

  const MeasureOptions& options_;
  ProgressBar& bar_;
  LightStage stage_;
  PictureError picture_;
  VoxelError voxel_error_;
  std::vector<Light> lights_;
  MeasuredRows measured_;
};

}  // namespace

MeasuredRows measure(const MeasureOptions& options, ProgressBar& bar) {
  Measure bench(options, bar);
  bench.run();
  return bench.measured();
}

}  // namespace rc2
