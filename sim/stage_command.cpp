#include "sim/stage_command.h"

#include "sim/light_stage.h"
#include "sw/base/config.h"

namespace rc2 {

void declare_stage_options(Command& command, StageOptions& options) {
  command.option("SCENE", options.scene, "A scene as light-error takes it").required();
  command.option("--n", options.n, "Side of the cube, in voxels").within(8, kMaxSide);
  command.option("--fraction-bits", options.fraction_bits, "Vertices are multiples of 2^-f voxel")
      .within(0, kMaxFractionBits);
  command.option("--lights", options.lights, "How many lights, one after another")
      .within(1, kStageLights);
  command.option("--out", options.out, "Write the table to this CSV file")
      .type("FILE.csv")
      .required();
}

}  // namespace rc2
