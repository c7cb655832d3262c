// Random packets that meet in the same voxels, so that their claims are compared and a column is
// long at work.
#pragma once

#include <glm/vec2.hpp>

#include "sw/facet/packet.h"
#include "sw/machine/machine.h"
#include "tb/load/dice.h"

namespace rc2::tb {

/// Up to `most` packets, of all layers or of armour only, for this machine. A third of them fill
/// their whole box, and half of them cover this cell.
facet::PacketStream dense_packets(facet::Dice& dice, const MachineConfig& config, int most,
                                  glm::ivec2 cell);

}  // namespace rc2::tb
