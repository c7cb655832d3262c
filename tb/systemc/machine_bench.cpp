// The SystemC bench around the whole machine.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tb/systemc/machine_job.h"
#include "tb/systemc/run.h"

int sc_main(int argc, char** argv) {
  using namespace rc2::tb;
  Experiment machine;
  machine.unit = fmt::format("machine of {0} x {0} cells", kMachine.n);
  machine.make = [](const RunOptions& options, const std::string& waves) {
    return options.model == "rtl" ? make_rtl_machine(waves) : make_cycle_machine();
  };
  machine.job = [](const RunOptions& options) {
    return std::make_unique<MachineJob>(options.seed, options.jobs);
  };
  machine.results = [](const Job& job) {
    return fmt::format("  busy cycles of each load and light: {}\n",
                       fmt::join(dynamic_cast<const MachineJob&>(job).busy_cycles(), " "));
  };
  return run(argc, argv, machine);
}
