// The SystemC bench around one cell of the thesis.
#include <fmt/format.h>

#include "tb/systemc/cell_job.h"
#include "tb/systemc/run.h"

int sc_main(int argc, char** argv) {
  using namespace rc2::tb;
  Experiment cell;
  cell.unit = fmt::format("cell of an array of {0} x {0}", kArray.n);
  cell.make = [](const RunOptions& options, const std::string& waves) {
    const auto at = chosen_cell(options.seed);
    return options.model == "rtl" ? make_rtl_cell(at, waves) : make_cycle_cell(at);
  };
  cell.job = [](const RunOptions& options) {
    return std::make_unique<CellJob>(chosen_cell(options.seed), options.seed, options.jobs);
  };
  return run(argc, argv, cell);
}
