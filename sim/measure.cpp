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

void declare_measure(CLI::App& program, ExitCode& exit_code) {
  auto options = std::make_shared<MeasureOptions>();
  auto* command = program.add_subcommand(
      "measure",
      "Run time beside error: loads and lights a scene in many ways, compares voxels, "
      "light and picture with the continuous scene (Embree)");
  declare_stage_options(*command, *options);
  command->add_option("--rule", options->rule, "Voxels of a facet, as for run")
      ->capture_default_str();
  command
      ->add_option("--coefficient-bits", options->coefficient_bits,
                   "Round planes to so many bits, widened to lose no voxel (default: exact)")
      ->check(CLI::Range(2, 62));
  command->add_option("--machine", options->machines, "Machines")
      ->delimiter(',')
      ->check(CLI::IsMember({"golden", "cycle", "rtl"}))
      ->capture_default_str();
  command->add_option("--mode", options->modes, "How light spreads")
      ->delimiter(',')
      ->check(CLI::IsMember({"fast", "thesis"}))
      ->capture_default_str();
  command
      ->add_option("--skip", options->skips,
                   "In fast mode, whether light that can meet nothing ends early: on, off")
      ->delimiter(',')
      ->check(CLI::IsMember({"on", "off"}))
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
    exit_code = within_memory(options->n, [&] { return write_rows(*options); });
  });
}

}  // namespace rc2
