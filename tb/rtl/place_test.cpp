// rc2_place against the division it replaces, for every target, step and distance of n = 16, with
// k/L as rc2_pace adds it up from the host's 1/L.
#include "sw/base/floor_divide.h"
#include "sw/machine/host_port.h"
#include "tb/rtl/block.h"

namespace {

TEST(Place, IsWhereTheRayIs) {
  rc2::MachineConfig config;
  config.n = 16;
  config.max_distance = 64;
  constexpr int kTargetBits = 8, kOffsetBits = 5;
  const int extra = rc2::coordinate_bits(config.n);
  rc2::tb::Module<Vtop> place;
  for (int distance = 1; distance <= config.max_distance; ++distance) {
    const std::uint64_t inverse = rc2::host_port::inverse_of(distance, rc2::inverse_bits(config));
    for (int k = 1; k < config.n; ++k) {
      place.slope_i = static_cast<IData>(static_cast<std::uint64_t>(k) * inverse >> extra);
      for (int target = -distance; target <= distance; ++target) {
        place.target_i = static_cast<CData>(rc2::tb::bits(target, kTargetBits));
        place.eval();
        const int offset = -rc2::floor_divide(distance - 2 * target * k, 2 * distance);
        ASSERT_EQ(place.offset_o, rc2::tb::bits(offset, kOffsetBits))
            << "target " << target << " k " << k << " L " << distance;
      }
    }
  }
}

}  // namespace
