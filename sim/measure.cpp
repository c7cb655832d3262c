// The benchmark's measurements of the machine: run time, work and error of every combination asked
// for, in one table.
#include <fmt/format.h>

#include <memory>

#include "sim/bench_run.h"
#include "sim/commands.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"

namespace rc2 {
namespace {

ExitCode write_rows(const MeasureOptions& options) {
  Outputs outputs;
  outputs.add_file(options.out);
  ProgressBar bar;
  const MeasuredRows measured = measure(options, bar);
  bar.wipe();
  replace_file(options.out, to_csv(measured.rows));
  fmt::print(
      "{} lights measured, {} skipped (no layers, or a machine that lacks the accurate rule)\n",
      measured.rows.size(), measured.skipped);
  outputs.keep();
  return kDone;
}

}  // namespace

void declare_measure(Command& program) {
  auto options = std::make_shared<MeasureOptions>();
  Command command = program.command(
      "measure",
      "Run time beside error: loads and lights a scene in many ways, compares voxels, "
      "light and picture with the continuous scene (Embree)");
  declare_stage_options(command, *options);
  command.option("--rule", options->rule, "Voxels of a facet, as for run");
  command
      .option("--coefficient-bits", options->coefficient_bits,
              "Round planes to so many bits, widened to lose no voxel (default: exact)")
      .within(2, 62);
  command.option("--machine", options->machines, "Machines")
      .list()
      .one_of({"golden", "cycle", "rtl"});
  command.option("--mode", options->modes, "How light spreads").list().one_of({"fast", "thesis"});
  command
      .option("--skip", options->skips,
              "In fast mode, whether light that can meet nothing ends early: on, off")
      .list()
      .one_of({"on", "off"});
  command.option("--light-rule", options->light_rules, "Rules of light")
      .list()
      .one_of({"thesis", "accurate"});
  command.option("--reach", options->reaches, "Distances L of the virtual faces, over n")
      .list()
      .within(0.1, 8.0);
  command.option("--fa", options->queues, "Beams that a cell has room for").list().within(1, 64);
  command.run(
      [options] { return within_memory(options->n, [&] { return write_rows(*options); }); });
}

}  // namespace rc2
