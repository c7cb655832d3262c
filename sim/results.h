#pragma once

#include "sim/job.h"
#include "sim/lights.h"
#include "sw/report/dump.h"
#include "sw/report/report.h"

namespace rc2 {

/// Writes the dump, if asked for, and both pictures of what the machine holds; adds them to the
/// report's list. Each file is written whole or not at all; throws Error.
void write_pictures(const RunOptions& options, const Job& job, const std::vector<Lamp>& lamps,
                    const report::Memories& memories, report::Report& report);

/// Writes report.json, the last file of a run.
void write_report(const RunOptions& options, report::Report& report);

}  // namespace rc2
