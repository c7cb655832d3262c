#include "tb/systemc/run.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "sw/base/error.h"
#include "tb/systemc/fault.h"
#include "tb/systemc/recorder.h"

namespace rc2::tb {
namespace {

// The waveform of the streams; closed at the end, whatever happens.
class Trace {
 public:
  explicit Trace(const std::string& path) {
    if (path.empty()) return;
    const auto folder = std::filesystem::path(path).parent_path();
    std::error_code failed;
    if (!folder.empty()) std::filesystem::create_directories(folder, failed);
    if (failed) {
      throw Error(fmt::format("--waves {}: the folder cannot be made ({}); name another", path,
                              failed.message()));
    }
    file_ = sc_core::sc_create_vcd_trace_file(path.c_str());
    file_->set_time_unit(1, sc_core::SC_NS);
  }
  ~Trace() {
    if (file_ != nullptr) sc_core::sc_close_vcd_trace_file(file_);
  }
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;

  sc_core::sc_trace_file* file() const { return file_; }

 private:
  sc_core::sc_trace_file* file_ = nullptr;
};

int simulate(const RunOptions& options, const Experiment& experiment) {
  const Trace trace(options.waves);
  const bool inside = !options.waves.empty() && options.model == "rtl";
  const auto made = experiment.make(options, inside ? options.waves + ".fst" : "");
  std::unique_ptr<FaultyUnit> faulty;
  if (!options.fault.empty()) {
    faulty = std::make_unique<FaultyUnit>(*made, Fault::parse(options.fault));
  }
  std::unique_ptr<RecordingUnit> recorder;
  if (!options.record.empty()) recorder = std::make_unique<RecordingUnit>(*made, options.record);
  Unit& unit = faulty     ? static_cast<Unit&>(*faulty)
               : recorder ? static_cast<Unit&>(*recorder)
                          : *made;
  const auto job = experiment.job(options);
  Bench bench("bench", unit, *job, options.seed, trace.file());
  sc_core::sc_start();

  const auto& difference = bench.scoreboard().difference();
  fmt::print("{}, {}, seed {}: {} cycles, {} beats checked, {}\n{}", experiment.unit, options.model,
             options.seed, this_cycle(), bench.scoreboard().checked(),
             difference ? "A DIFFERENCE" : "no difference", bench.summary());
  if (experiment.results) fmt::print("{}", experiment.results(*job));
  if (!options.waves.empty()) {
    fmt::print("  waves: {}.vcd, 10 ns are a cycle{}\n", options.waves,
               inside ? fmt::format("; inside the unit {}.fst, 10 units are a cycle", options.waves)
                      : std::string());
  }
  if (!difference) return 0;
  fmt::print("{}", to_text(*difference));
  return 1;
}

}  // namespace

int run(int argc, char** argv, const Experiment& experiment) {
  // SystemC greets and says goodbye otherwise.
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  RunOptions options;
  CLI::App program("The SystemC test bench of " + experiment.unit +
                   "; exit code 0: no difference, 1: a difference, 2: bad input");
  program.add_option("--model", options.model, "What stands in the bench")
      ->check(CLI::IsMember({"rtl", "cycle"}))
      ->capture_default_str();
  program.add_option("--seed", options.seed, "Of the jobs and the stalls")->capture_default_str();
  program.add_option("--jobs", options.jobs, "How many, one after another")->capture_default_str();
  program.add_option("--fault", options.fault, "Break the unit: KIND:STREAM:BEAT");
  program
      .add_option("--record", options.record,
                  "Write the pins in every cycle to this file, for tb/netlist/replay.v")
      ->excludes("--fault");
  program.add_option("--waves", options.waves, "Write PATH.vcd, and PATH.fst of rtl")
      ->type_name("PATH");
  try {
    program.parse(argc, argv);
    return simulate(options, experiment);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}

}  // namespace rc2::tb
