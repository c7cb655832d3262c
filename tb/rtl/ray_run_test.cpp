// rc2_ray_run against a walk voxel by voxel, as sw/cycle/ray_walk.cpp has it.
#include <vector>

#include "tb/rtl/ray_ports.h"

namespace {

using namespace rc2;
using namespace rc2::tb;

TEST(RayRun, PassesTheVoxelsOfTheWalk) {
  Module<Vtop> run;
  scene::Random random(3);
  const int fraction = rays::slope_fraction(kSide), width = rays::slope_bits(kSide);
  int leaving = 0;
  for (int i = 0; i < 40000; ++i) {
    const bool down = random.below(2) == 0;
    const int z = random.below(kSide), up = down ? -1 : 1;
    // What stands for infinity, now and then.
    const std::int64_t limit = std::int64_t{rays::steepest(kSide)} << fraction;
    const std::int64_t height = (random.below(3 * kSide) - kSide) * (std::int64_t{1} << fraction) +
                                random.below(1 << fraction);
    const std::int64_t exit = random.below(10) == 0 ? height + up * limit / 2 : height;
    std::vector<bool> worth(kSide);
    for (int k = 0; k < kSide; ++k) worth[static_cast<std::size_t>(k)] = random.below(3) == 0;

    run.z_i = static_cast<CData>(z);
    run.down_i = down ? 1 : 0;
    set_fields(run.exit_i, {{exit, width}});
    std::uint32_t limbs[(kSide + 31) / 32] = {};
    for (int k = 0; k < kSide; ++k)
      limbs[k / 32] |= static_cast<std::uint32_t>(worth[static_cast<std::size_t>(k)]) << k % 32;
    std::memcpy(static_cast<void*>(&run.worth_i), limbs, sizeof run.worth_i);
    run.eval();

    const auto exit_z = static_cast<int>((exit + (std::int64_t{1} << (fraction - 1))) >> fraction);
    const int last = up * std::max(up * z, up * exit_z);
    std::vector<bool> todo(kSide);
    int at = z;
    for (; at >= 0 && at < kSide; at += up) {
      todo[static_cast<std::size_t>(at)] = worth[static_cast<std::size_t>(at)];
      if (at == last) break;
    }
    const bool leaves = at < 0 || at >= kSide;
    leaving += leaves ? 1 : 0;
    ASSERT_EQ(run.leaves_o != 0, leaves) << i;
    if (!leaves) {
      ASSERT_EQ(run.last_o, last) << i;
    }
    for (int k = 0; k < kSide; ++k)
      ASSERT_EQ(field_of(run.todo_o, down ? kSide - 1 - k : k, 1, false) != 0,
                todo[static_cast<std::size_t>(k)])
          << i << " voxel " << k;
  }
  EXPECT_GT(leaving, 1000);
}

}  // namespace
