// Thesis 4.3.2: the table from which a cell could read where a beam goes.
#include "sw/emission/path_table.h"

#include <fmt/format.h>

#include <memory>

#include "sim/table_command.h"

namespace rc2 {
namespace {

struct PathTableOptions {
  std::vector<int> sides = {4, 16, 64};
  bool rows = false;
};

void print(const PathTableOptions& options) {
  fmt::print("{:>5}{:>7}{:>8}{:>12}{:>12}{:>12}{:>12}{:>8}\n", "n", "rays", "steps", "ways", "bits",
             "half of it", "last steps", "2n/3");
  for (const int n : options.sides) {
    const emission::TableFacts facts = emission::octant_facts(n);
    const std::int64_t bits = std::int64_t{n} * (n - 1);
    fmt::print("{:>5}{:>7}{:>8}{:>12}{:>12}{:>12}{:>12}{:>8.0f}\n", n, n, n - 1, facts.prefixes,
               bits, bits / 2, facts.last_steps, 2.0 * n / 3);
    if (!options.rows) continue;
    const emission::PathTable table(0, n - 1, n - 1);
    for (const emission::Path& path : table.paths()) fmt::print("{}\n", path);
  }
}

}  // namespace

void declare_path_table(Command& program) {
  auto options = std::make_shared<PathTableOptions>();
  Command command = program.command(
      "path-table", "How large a table would be that says where beams part (4.3.2)");
  declare_list(command, "--n", options->sides, 2, 512, "Sides of the cube, in voxels");
  command.flag("--rows", options->rows, "Print the tables: 0 straight on, 1 one outward");
  command.run([options] {
    print(*options);
    return kDone;
  });
}

}  // namespace rc2
