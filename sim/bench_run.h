// Runs of the machine for the benchmark: every combination asked for, on one scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/bench_row.h"
#include "sim/progress_bar.h"
#include "sim/stage_command.h"

namespace rc2 {

struct MeasureOptions : StageOptions {
  std::string rule = "armoured";
  std::optional<int> coefficient_bits;  ///< as for LightStage
  std::vector<std::string> machines = {"golden", "cycle"};
  std::vector<std::string> modes = {"fast"};
  std::vector<std::string> skips = {"on"};
  std::vector<std::string> light_rules = {"thesis", "accurate"};
  std::vector<double> reaches = {2};  ///< distances L of the virtual faces, over n
  std::vector<int> queues = {8};
};

struct MeasuredRows {
  std::vector<BenchRow> rows;
  /// Lights by the accurate rule for voxels without layers, or a machine that lacks the rule.
  std::int64_t skipped = 0;
};

/// Throws Error if there is nothing to light, or a machine cannot do what is asked for.
MeasuredRows measure(const MeasureOptions& options, ProgressBar& bar);

}  // namespace rc2
