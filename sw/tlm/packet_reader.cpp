#include "sw/tlm/packet_reader.h"

#include "sw/base/error.h"

namespace rc2::tlm {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw Error(std::string("a word of a packet is out of place: ") + what +
              "; a packet is HEAD, SLAB, its SIDEs and GAP, and END stands between packets");
}

}  // namespace

void PacketReader::read(const Word& word) {
  const bool open = last_ != WordKind::gap;
  switch (word.kind) {
    case WordKind::head:
      if (open) refuse("HEAD before the GAP of the packet before");
      begin(word);
      break;
    case WordKind::slab:
      if (last_ != WordKind::head) refuse("SLAB without its HEAD");
      packets_.heads.back().slab.value = linear(word);
      break;
    case WordKind::side:
      if (last_ != WordKind::slab && last_ != WordKind::side) refuse("SIDE without its SLAB");
      packets_.sides.push_back({linear(word), word.reach});
      ++packets_.heads.back().side_count;
      break;
    case WordKind::gap:
      if (last_ != WordKind::slab && last_ != WordKind::side) refuse("GAP without its SLAB");
      packets_.heads.back().gap = linear(word);
      packets_.heads.back().surface = word.surface;
      break;
    case WordKind::end:
      if (open) refuse("END in the middle of a packet");
      if (packets_.batches.empty() || packets_.batches.back().ends_object) {
        packets_.batches.push_back({static_cast<std::uint32_t>(packets_.heads.size()), 0, false});
      }
      packets_.batches.back().ends_object = true;
      return;
    default:
      refuse("neither part of a packet nor END");
  }
  last_ = word.kind;
}

void PacketReader::begin(const Word& head) {
  const glm::ivec3 lo(head.skip[0], head.skip[1], head.z0);
  const glm::ivec3 size(head.take[0] - 1, head.take[1] - 1, head.z_span);
  // Packets of one layer may come in any order, so they are one batch until an object ends.
  const auto number = static_cast<std::uint32_t>(packets_.heads.size());
  if (packets_.batches.empty() || packets_.batches.back().ends_object ||
      packets_.heads.back().layer != head.layer) {
    packets_.batches.push_back({number, 0, false});
  }
  ++packets_.batches.back().count;
  packets_.heads.push_back({head.facet,
                            lo,
                            lo + size,
                            {{}, head.reach},
                            {},
                            static_cast<std::uint32_t>(packets_.sides.size()),
                            0,
                            head.layer});
}

const facet::PacketStream& PacketReader::packets() const {
  if (last_ != WordKind::gap) refuse("the packet is not at its end");
  return packets_;
}

}  // namespace rc2::tlm
