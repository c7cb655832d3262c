// The main job: a scene into a machine, light into the scene, and what came of it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "sim/build_info.h"
#include "sim/commands.h"
#include "sim/drive.h"
#include "sim/job.h"
#include "sim/lights.h"
#include "sim/machines.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/results.h"
#include "sim/stopwatch.h"
#include "sw/machine/feeder.h"
#include "sw/machine/find_voxel.h"
#include "sw/report/compare.h"

namespace rc2 {
namespace {

constexpr const char* kReference = "golden";

report::Report describe(const RunOptions& options, const Job& job) {
  report::Report report;
  report.scene = options.scene;
  report.fit = options.fitted() ? "cube" : "none";
  report.machine = options.machine;
  report.rule = options.rule;
  report.light_rule = to_string(options.rule_of_light());
  report.mode = options.mode;
  report.hop_stages = hop_stages(options.light_mode());
  report.n = options.n;
  report.fraction_bits = options.fraction_bits;
  report.target_distance = options.distance();
  report.fa = options.fa;
  report.feeders = options.feeder_count();
  report.load_words = busiest_feeder_words(job.facets.packets, report.feeders);
  report.facets = job.facets.counts;
  report.ignored = {job.scene.ignored_primitives, job.scene.ignored_lights,
                    job.scene.ignored_textures};
  report.reference = kReference;
  report.commit = source_commit();
  report.tools = tool_versions();
  return report;
}

// Loads and lights the machine, and puts into the report what it did.
report::Memories run_machine(const RunOptions& options, const Job& job, Lamps& lamps,
                             ProgressBar& bar, Stopwatch& watch, report::Report& report) {
  const auto machine = make_machine(options.machine, options.needs(),
                                    {options.waves, options.waves_from, options.waves_cycles});
  Drive drive(*machine, options.machine, bar);
  drive.load(job.facets);
  place_lamps(lamps, drive.memories().voxels, options.n);
  watch.lap("load");
  const auto results =
      drive.light(lamps.list, options.distance(), options.fa, options.rule_of_light());
  watch.lap("light");

  report.load.cycles = drive.load_cycles();
  report.lights = lamps.counts;
  report.voxels = static_cast<std::int64_t>(drive.memories().voxels.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    const LightMemory& counts = drive.memories().lights[k];
    const auto dark = std::count(counts.begin(), counts.end(), 0U);
    report.sources.push_back(
        {lamps.list[k].voxel, lamps.list[k].colour, results[k], report.voxels - dark});
  }
  return drive.memories();
}

report::Comparison compare_with_reference(const RunOptions& options, const Job& job,
                                          const Lamps& lamps, ProgressBar& bar,
                                          const report::Memories& memories) {
  const auto golden = make_machine(kReference, options.needs());
  Drive drive(*golden, kReference, bar);
  drive.load(job.facets);
  // A machine that lost a voxel may have a lamp where the reference has none to spare. Without
  // the reference's light all counts of light differ.
  const bool free = std::none_of(lamps.list.begin(), lamps.list.end(), [&](const Lamp& lamp) {
    return find_voxel(drive.memories().voxels, lamp.voxel) != nullptr;
  });
  if (free) drive.light(lamps.list, options.distance(), options.fa, options.rule_of_light());
  return report::compare(drive.memories(), memories);
}

void note_waves(const RunOptions& options, report::Report& report) {
  if (options.waves.empty()) return;
  if (std::filesystem::exists(options.waves)) {
    report.written.emplace_back("waves", options.waves);
  } else {
    fmt::print(stderr, "rc2: there is no waveform, because the run ended before cycle {}\n",
               options.waves_from);
  }
}

ExitCode run(RunOptions options) {
  check_options(options);
  Stopwatch watch;
  const Job job = prepare(options, options.rule_of_light() == LightRule::accurate);
  Lamps lamps = choose_lamps(options.lights, job.scene, options.n);
  watch.lap("scene");
  Outputs outputs;
  outputs.add_folder(options.out);
  if (!options.dump.empty()) outputs.add_file(options.dump);
  if (!options.volume.empty()) outputs.add_file(options.volume);
  if (!options.waves.empty()) outputs.add_waves(options.waves);

  ProgressBar bar;
  report::Report report = describe(options, job);
  const report::Memories memories = run_machine(options, job, lamps, bar, watch, report);
  if (options.machine != kReference) {
    report.agreement = compare_with_reference(options, job, lamps, bar, memories);
    watch.lap("golden");
  }
  write_pictures(options, job, lamps.list, memories, report);
  watch.lap("pictures");
  note_waves(options, report);
  report.seconds = watch.laps();
  write_report(options, report);
  outputs.keep();
  fmt::print("{}", report::to_text(report));
  if (report.agreement.equal()) return kDone;
  fmt::print(stderr, "rc2: {} disagrees with the {} model; see the report\n", options.machine,
             kReference);
  return kDisagreement;
}

}  // namespace

void declare_run(Command& program) {
  auto options = std::make_shared<RunOptions>();
  Command command = program.command(
      "run",
      "Loads a scene, lights it, checks the machine against the golden model and writes pictures "
      "and a report; exit code 0: done, 2: bad input, 3: the models disagree, 4: internal error");
  declare_run_options(command, *options);
  command.run([options] { return within_memory(options->n, [&] { return run(*options); }); });
}

}  // namespace rc2
