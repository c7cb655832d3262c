// From the words of one row feeder that serves all rows back to packets.
#pragma once

#include "sw/facet/packet.h"
#include "sw/machine/word.h"

namespace rc2::tlm {

class PacketReader {
 public:
  /// Takes the next word of a packet, or END. Throws Error if it cannot come here.
  void read(const Word& word);

  /// The packets so far, all whole. Throws Error in the middle of one.
  const facet::PacketStream& packets() const;

 private:
  void begin(const Word& head);
  facet::Linear linear(const Word& word) const {
    return {word.step[0], word.step[1], word.c, word.d};
  }

  facet::PacketStream packets_;
  WordKind last_ = WordKind::gap;  // of the packet under way; gap if there is none
};

}  // namespace rc2::tlm
