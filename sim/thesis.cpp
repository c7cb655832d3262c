#include <fmt/format.h>

#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <string>
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

struct ThesisOptions {
  std::string table;
  bool snapshots = false;
  std::string n, fa;
  std::string conflict = "head-waits";
  std::vector<std::int64_t> times = {0, 25, 50, 75, 100};
  std::string out;
};

Range parse_range(const char* option, const std::string& text) {
  Range range{};
  const char* const end = text.data() + text.size();
  auto [rest, error] = std::from_chars(text.data(), end, range.first);
  range.last = range.first;
  if (error == std::errc{} && std::string_view(rest, end - rest).substr(0, 2) == "..") {
    std::tie(rest, error) = [&] {
      const auto result = std::from_chars(rest + 2, end, range.last);
      return std::pair(result.ptr, result.ec);
    }();
  }
  if (error != std::errc{} || rest != end) {
    throw Error(fmt::format("{} {}: not a number or a range of numbers; write it like 16 or 2..64",
                            option, text));
  }
  return range;
}
