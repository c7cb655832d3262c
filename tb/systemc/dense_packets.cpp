#include "tb/systemc/dense_packets.h"

#include <algorithm>

#include "tb/unit/random_packets.h"

namespace rc2::tb {

facet::PacketStream dense_packets(facet::Dice& dice, const MachineConfig& config, int most,
                                  glm::ivec2 cell) {
  const auto count = static_cast<int>(dice.roll(1, most));
  const std::int64_t largest = std::int64_t{1}
                               << (2 * (coordinate_bits(config.n) + config.fraction_bits));
  const std::int64_t scale = dice.one_in(2) ? 4 : largest;
  facet::PacketStream packets =
      dice.one_in(3) ? random_packets(dice, config.n, count, scale, config.fraction_bits)
                     : random_layers(dice, config.n, count, scale, config.fraction_bits);
  for (facet::PacketHead& packet : packets.heads) {
    if (dice.one_in(3)) {
      packet.slab.value = {0, 0, 0, 0};
      packet.side_count = 0;
    }
    if (dice.one_in(2)) {
      packet.lo = {std::min(packet.lo.x, cell.x), std::min(packet.lo.y, cell.y), packet.lo.z};
      packet.hi = {std::max(packet.hi.x, cell.x), std::max(packet.hi.y, cell.y), packet.hi.z};
    }
  }
  return packets;
}

}  // namespace rc2::tb
