#include "sim/stage_command.h"

#include "sim/light_stage.h"
#include "sw/base/config.h"

namespace rc2 {

void declare_stage_options(CLI::App& command, StageOptions& options) {
  command.add_option("SCENE", options.scene, "A scene as light-error takes it")->required();
  command.add_option("--n", options.n, "Side of the cube, in voxels")
      ->check(CLI::Range(8, kMaxSide))
      ->capture_default_str();
  command
      .add_option("--fraction-bits", options.fraction_bits, "Vertices are multiples of 2^-f voxel")
      ->check(CLI::Range(0, kMaxFractionBits))
      ->capture_default_str();
  command.add_option("--lights", options.lights, "How many lights, one after another")
      ->check(CLI::Range(1, kStageLights))
      ->capture_default_str();
  command.add_option("--out", options.out, "Write the table to this CSV file")
      ->type_name("FILE.csv")
      ->required();
}

}  // namespace rc2
