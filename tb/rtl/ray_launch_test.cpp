// rc2_ray_launch against sw/rays: what a ray is given for its way, bit for bit, and in how many
// cycles.
#include "sw/cycle/ray_timing.h"
#include "sw/rays/launch.h"
#include "tb/rtl/ray_ports.h"

namespace {

using namespace rc2;
using namespace rc2::tb;

constexpr int kRounds = 4000;

class RayLaunch : public ::testing::Test {
 protected:
  RayLaunch() { unit_.top.take_i = unit_.top.leave_i = 0; }

  Clocked<Vtop> unit_;
  scene::Random random_{1};
};

// Another may be taken in the cycle in which the one before leaves.
TEST_F(RayLaunch, GivesARayItsWay) {
  const int rise = rays::slope_bits(kSide), coordinate = coordinate_bits(kSide);
  for (int i = 0; i < kRounds; ++i) {
    const rays::Ray ray = any_ray(random_);
    set_fields(unit_.top.begin_i, start_fields(ray));
    unit_.top.take_i = 1;
    unit_.tick();
    unit_.top.take_i = unit_.top.leave_i = 0;
    set_fields(unit_.top.begin_i, {{0, 1}});
    int cycles = 1;
    for (unit_.settle(); unit_.top.ready_o == 0; ++cycles) {
      ASSERT_EQ(unit_.top.work_o, 1);
      unit_.tick();
    }
    ASSERT_EQ(cycles, cycle::ray_timing::launch(kSide));
    for (int waits = random_.below(3); waits > 0; --waits) unit_.tick();
    FieldsFromBelow fields(unit_.top.ray_o);
    fields.skip(kFaceBits + 3 * coordinate + 3);
    ASSERT_EQ(fields.take(coordinate, false), rays::voxel_of(ray.origin.z));
    const rays::Launch want = rays::launch(ray, kSide);
    ASSERT_EQ(fields.take(rise), want.slope_y) << i;
    ASSERT_EQ(fields.take(rise), want.slope_x) << i;
    ASSERT_EQ(fields.take(rise), want.exit_y) << i;
    ASSERT_EQ(fields.take(rise), want.exit_x) << i;
    ASSERT_EQ(fields.take(rays::decision_bits(kSide)), want.decision) << i;
    unit_.top.leave_i = 1;
    if (random_.below(2) == 0) {
      unit_.tick();
      unit_.top.leave_i = 0;
      unit_.settle();
      ASSERT_EQ(unit_.top.busy_o, 0);
    }
  }
}

}  // namespace
