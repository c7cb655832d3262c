// What the benchmark's commands have in common: one scene, some lights, one table of BenchRow.
#pragma once

#include <string>

#include "sim/command_line.h"

namespace rc2 {

struct StageOptions {
  std::string scene;
  int n = 64;
  int fraction_bits = 6;
  int lights = 3;
  std::string out;  ///< CSV file
};

/// SCENE, --n, --fraction-bits, --lights and --out.
void declare_stage_options(Command& command, StageOptions& options);

}  // namespace rc2
