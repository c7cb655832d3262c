#include "sw/report/compare.h"

#include <fmt/format.h>

#include <memory>

#include "sim/commands.h"

namespace rc2 {
namespace {

struct Files {
  std::string expected, got;
};

ExitCode compare_files(const Files& files) {
  const report::Comparison result =
      report::compare(report::read_csv(files.expected), report::read_csv(files.got));
  fmt::print("voxels differing  {}\nowners differing  {}\nlights differing  {}\n",
             result.voxels_differing, result.owners_differing, result.lights_differing);
  for (const report::Difference& difference : result.first) {
    fmt::print("  {}\n", report::to_string(difference));
  }
  return result.equal() ? kDone : kDifferent;
}

}  // namespace

void declare_compare(Command& program) {
  auto files = std::make_shared<Files>();
  Command command = program.command(
      "compare",
      "Compares two dumps voxel by voxel; exit code 0: equal, 1: different, 2: not readable");
  command.option("EXPECTED", files->expected, "A file of --dump").required();
  command.option("GOT", files->got, "Another one").required();
  command.run([files] { return compare_files(*files); });
}

}  // namespace rc2
