// One run of a bench: its command line, its waveforms, what it says at the end.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tb/systemc/bench.h"

namespace rc2::tb {

struct RunOptions {
  std::string model = "rtl";  ///< rtl or cycle
  std::uint64_t seed = 1;
  std::int64_t jobs = 20;
  std::string fault;   ///< Fault::parse
  std::string record;  ///< where the pins are written down (RecordingUnit), or empty
  std::string waves;   ///< the waveforms' path without ending, or empty
};

/// What one bench is about.
struct Experiment {
  std::string unit;  ///< its name, for people
  /// The unit of the model asked for; `waves` is the path of an FST file, or empty.
  std::function<std::unique_ptr<Unit>(const RunOptions& options, const std::string& waves)> make;
  std::function<std::unique_ptr<Job>(const RunOptions& options)> job;
  /// More lines for the end of the summary.
  std::function<std::string(const Job& job)> results;
};

/// Runs it. Returns 0, or 1 after a difference, or 2 after bad input.
int run(int argc, char** argv, const Experiment& experiment);

}  // namespace rc2::tb
