#include <fmt/format.h>

#include <memory>

#include "sim/commands.h"
#include "sim/job.h"
#include "sim/machines.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"
#include "sw/report/dump.h"
#include "sw/report/laws.h"

namespace rc2 {
namespace {

ExitCode voxelize(SceneOptions options) {
  check_options(options);
  const Job job = prepare(options);
  Outputs outputs;
  if (!options.dump.empty()) outputs.add_file(options.dump);

  const auto machine = make_machine(
      options.machine, {options.n, options.fraction_bits, 1, 1, options.feeder_count()});
  ProgressBar bar;
  const LoadResult load =
      machine->load(job.facets.packets, bar.step("loading on " + options.machine));
  const report::Memories memories{machine->read_voxels(), {}};
  bar.wipe();
  report::check_voxels(memories.voxels, options.n, job.facets.facets.size());
  if (!options.dump.empty()) replace_file(options.dump, report::to_csv(memories));

  const facet::FacetCounts& counts = job.facets.counts;
  fmt::print(
      "polygons read          {}\n"
      "split into triangles   {}\n"
      "without area, dropped  {}\n"
      "outside, dropped       {}\n"
      "facets loaded          {}\n"
      "voxels occupied        {}\n",
      counts.read, counts.triangulated, counts.degenerate, counts.outside, counts.loaded,
      memories.voxels.size());
  if (options.machine != "golden") fmt::print("clock cycles           {}\n", load.cycles);
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_voxelize(CLI::App& program, ExitCode& exit_code) {
  auto options = std::make_shared<SceneOptions>();
  auto* command =
      program.add_subcommand("voxelize", "Loads a scene without lighting it and counts its voxels");
  declare_scene_options(*command, *options, "golden");
  command->callback([options, &exit_code] {
    exit_code = within_memory(options->n, [&] { return voxelize(*options); });
  });
}

}  // namespace rc2
