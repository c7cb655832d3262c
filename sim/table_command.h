// What commands have in common that measure scenes at several sizes and write a table.
#pragma once

#include <string>
#include <vector>

#include "sim/commands.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"

namespace rc2 {

struct TableOptions {
  std::vector<std::string> scenes;
  std::vector<int> sides;
  std::string out;  ///< CSV file; empty: none
};

/// SCENE, --n and --out; `scenes` says which are taken.
void declare_table_options(Command& command, TableOptions& options, const char* scenes);

/// A list of numbers between commas.
void declare_list(Command& command, const char* name, std::vector<int>& list, int low, int high,
                  const char* help);

/// Of every scene and side measure(scene, n, bar, rows), then print(rows); to_csv(rows) goes to the
/// CSV file. A run that fails leaves no file behind.
template <typename Row, typename Measure, typename Print, typename ToCsv>
ExitCode make_table(const TableOptions& options, Measure measure, Print print, ToCsv to_csv) {
  Outputs outputs;
  if (!options.out.empty()) outputs.add_file(options.out);
  ProgressBar bar;
  std::vector<Row> rows;
  for (const std::string& scene : options.scenes)
    for (const int n : options.sides) within_memory(n, [&] { measure(scene, n, bar, rows); });
  bar.wipe();
  print(rows);
  if (!options.out.empty()) replace_file(options.out, to_csv(rows));
  outputs.keep();
  return kDone;
}

}  // namespace rc2
