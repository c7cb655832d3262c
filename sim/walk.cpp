// Chapter 3: where the words of a few packets are while they are loaded, cycle by cycle.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <tuple>

#include "sim/commands.h"
#include "sim/job.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sw/base/replace_file.h"
#include "sw/cycle/cycle_machine.h"

namespace rc2 {
namespace {

using cycle::StageView;

// Of any other machine neither the file nor the picture would be of use.
constexpr int kLargest = 64;
constexpr std::size_t kMostFacets = 100;

ExitCode walk(SceneOptions options) {
  check_options(options);
  const Job job = prepare(options);
  if (job.facets.facets.size() > kMostFacets) {
    throw Error(fmt::format("{}: {} facets are too many to follow; choose a scene of at most {}",
                            options.scene, job.facets.facets.size(), kMostFacets));
  }
  Outputs outputs;
  outputs.add_file(options.dump);

  MachineConfig config;
  config.n = options.n;
  config.fraction_bits = options.fraction_bits;
  config.feeders = options.feeder_count();
  cycle::CycleMachine machine(config);
  std::string csv = "cycle,x,y,words,divides,writes\n";
  machine.observe_load([&](std::int64_t cycle, std::vector<StageView> stages) {
    std::sort(stages.begin(), stages.end(), [](const StageView& a, const StageView& b) {
      return std::tie(a.y, a.x) < std::tie(b.y, b.x);
    });
    for (const StageView& stage : stages) {
      csv += fmt::format("{},{},{},{},{:d},{:d}\n", cycle, stage.x, stage.y, stage.words,
                         stage.divides, stage.writes);
    }
  });
  const std::int64_t cycles = machine.load(job.facets.packets, {}).cycles;
  replace_file(options.dump, csv);
  fmt::print("facets {}, clock cycles {}\n", job.facets.facets.size(), cycles);
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_walk(Command& program) {
  auto options = std::make_shared<SceneOptions>();
  Command command = program.command(
      "walk", "Follows the words of a few facets through the array while it loads (chapter 3)");
  command.option("SCENE", options->scene, "A file in voxel coordinates, or a generated scene")
      .required();
  options->n = 8;
  options->fit = "none";
  command.option("--n", options->n, "Cells per side and voxels per column").within(2, kLargest);
  command.option("--feeders", options->feeders,
                 "Row feeders, a power of two (default: 1 for n < 8, then n / 4, at most 16)");
  command
      .option("--out", options->dump,
              "Write every stage that is busy, in every cycle, to this CSV file")
      .type("FILE.csv")
      .required();
  command.run([options] { return walk(*options); });
}

}  // namespace rc2
