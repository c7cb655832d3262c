#include "sim/table_command.h"

namespace rc2 {

void declare_list(Command& command, const char* name, std::vector<int>& list, int low, int high,
                  const char* help) {
  command.option(name, list, help).list().within(low, high);
}

void declare_table_options(Command& command, TableOptions& options, const char* scenes) {
  command.option("SCENE", options.scenes, scenes).required();
  declare_list(command, "--n", options.sides, 8, kMaxSide, "Sides of the cube, in voxels");
  command.option("--out", options.out, "Write the table to this CSV file").type("FILE.csv");
}

}  // namespace rc2
