// What each row feeder gets of the packets.
//
// Feeder k of R serves the rows y = k, k + R, k + 2R, ...: neighbouring rows, which most facets
// have, belong to different feeders. All feeders take words at the same time. Neighbours in a mesh
// want the same cells, so packets do not go in its order but far apart from each other; the order
// changes no result.
#pragma once

#include <cstddef>

#include "sw/facet/packet.h"
#include "sw/machine/word.h"

namespace rc2 {

class FeederWords {
 public:
  /// The words of feeder `feeder` (0 .. feeders-1). `packets` must outlive this.
  FeederWords(const facet::PacketStream& packets, int feeder, int feeders);

  bool done() const { return sent_ == packets_.heads.size(); }

  /// The next word, only if not done: values stand at the first cell of the packet's box in the
  /// feeder's first row of it; rows are counted in the feeder's rows.
  Word next();

  /// Share of the packets gone through, 0 .. 1.
  double share() const;

 private:
  const facet::PacketHead& head() const { return packets_.heads[packet_]; }
  // Goes on, if need be, to a packet that has rows of this feeder.
  void find_packet();
  void next_packet();
  Word linear_word(WordKind kind, const facet::Linear& value) const;

  const facet::PacketStream& packets_;
  int feeder_, feeders_;
  std::size_t stride_;  // from one packet to the next, modulo their number
  std::size_t packet_ = 0, sent_ = 0;
  std::uint32_t word_ = 0;  // of the packet; 0 is its HEAD
  int first_row_ = 0, rows_ = 0;
};

}  // namespace rc2
