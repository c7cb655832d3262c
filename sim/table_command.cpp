#include "sim/table_command.h"

namespace rc2 {

void declare_list(CLI::App& command, const char* name, std::vector<int>& list, int low, int high,
                  const char* help) {
  command.add_option(name, list, help)
      ->delimiter(',')
      ->check(CLI::Range(low, high))
      ->capture_default_str();
}

void declare_table_options(CLI::App& command, TableOptions& options, const char* scenes) {
  command.add_option("SCENE", options.scenes, scenes)->required();
  declare_list(command, "--n", options.sides, 8, kMaxSide, "Sides of the cube, in voxels");
  command.add_option("--out", options.out, "Write the table to this CSV file")
      ->type_name("FILE.csv");
}

}  // namespace rc2
