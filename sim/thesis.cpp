#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/commands.h"
#include "sim/memory.h"
#include "sim/outputs.h"
#include "sim/progress_bar.h"
#include "sw/base/replace_file.h"
#include "sw/picture/png.h"
#include "sw/thesis/snapshots.h"
#include "sw/thesis/tables.h"

namespace rc2 {
namespace {

using thesis::Conflict;
using thesis::Range;
using thesis::Table;

const std::map<std::string, Table> kTables = {{"fa_max", Table::kFaMax},
                                              {"fa1", Table::kFa1},
                                              {"fa_sweep", Table::kFaSweep},
                                              {"modes", Table::kModes}};
const std::map<std::string, Conflict> kConflicts = {{"head-waits", Conflict::kHeadWaits},
                                                    {"back-to-tail", Conflict::kBackToTail}};

template <typename Value>
std::vector<std::string> names(const std::map<std::string, Value>& values) {
  std::vector<std::string> found;
  found.reserve(values.size());
  for (const auto& [name, value] : values) found.push_back(name);
  return found;
}

struct ThesisOptions {
  std::string table;
  bool snapshots = false;
  std::string n = "16";
  std::string fa;
  std::string conflict = "head-waits";
  std::vector<std::int64_t> times = {0, 25, 50, 75, 100};
  std::string out;
};

// The whole text as a number.
std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size()) return {};
  return value;
}

Range parse_range(const char* option, std::string_view text) {
  const auto dots = text.find("..");
  const auto first = number(text.substr(0, dots));
  const auto last = dots == std::string_view::npos ? first : number(text.substr(dots + 2));
  if (!first || !last) {
    throw Error(
        fmt::format("{} {} is neither a number nor a range; write 16 or 2..64", option, text));
  }
  return {*first, *last};
}

int parse_one(const char* option, std::string_view text, int lowest, int highest) {
  const auto value = number(text);
  if (!value || *value < lowest || *value > highest) {
    throw Error(fmt::format("{} '{}': snapshots take one number; choose {} to {}", option, text,
                            lowest, highest));
  }
  return *value;
}

void write_table(const ThesisOptions& options) {
  thesis::TableRequest request{kTables.at(options.table),
                               parse_range("--n", options.n),
                               {},
                               kConflicts.at(options.conflict)};
  if (!options.fa.empty()) request.fa = parse_range("--fa", options.fa);
  thesis::check(request);
  Outputs outputs;
  outputs.add_file(options.out);
  ProgressBar bar;
  const std::string csv =
      within_memory(request.n.last, [&] { return to_csv(request, bar.step(options.table)); });
  bar.wipe();
  replace_file(options.out, csv);
  outputs.keep();
}

void write_snapshots(const ThesisOptions& options) {
  const int n = parse_one("--n", options.n, 2, thesis::kMaxSheetSide);
  const int fa = parse_one("--fa", options.fa, 1, thesis::kMaxFa);
  Outputs outputs;
  outputs.add_file(options.out);
  const thesis::ContactSheet sheet =
      draw_contact_sheet(thesis::centre(n, fa, kConflicts.at(options.conflict)), options.times);
  picture::write_png(options.out, sheet.raster);
  fmt::print("states after {} cycles, the last one is the end\n", fmt::join(sheet.times, ", "));
  outputs.keep();
}

}  // namespace

void declare_thesis(Command& program) {
  auto options = std::make_shared<ThesisOptions>();
  Command command = program.command(
      "thesis", "Repeats the simulations of the thesis (4.4.3) on its own coarse simulator");
  Command what = command.choice("what");
  const Option table =
      what.option("--table", options->table,
                  "A table as CSV: fa_max, fa1, fa_sweep, or modes (rays one by one against "
                  "beams, 4.2.6)")
          .one_of(names(kTables));
  what.flag("--snapshots", options->snapshots,
            "A PNG of the voxels reached and the cells at work, light in the centre");
  command.option("--n", options->n, "Sides of the cube: N, or A..B for a table");
  command.option("--fa", options->fa,
                 "Depth of the queues: F for snapshots, A..B for the table fa_sweep");
  command
      .option("--conflict", options->conflict,
              "What a beam does while a receiving cell is full: head-waits or back-to-tail")
      .one_of(names(kConflicts));
  command
      .option("--times", options->times, "Cycles after which a snapshot is taken, besides the end")
      .list()
      .excludes(table);
  command.option("--out", options->out, "The file to write").required();
  command.run([options] {
    options->snapshots ? write_snapshots(*options) : write_table(*options);
    return kDone;
  });
}

}  // namespace rc2
