// What each row feeder gets of the packets.
//
// Feeder k of R serves the rows y = k, k + R, k + 2R, ...: neighbouring rows, which most facets
// have, belong to different feeders. All feeders take words at the same time. Neighbours in a mesh
// want the same cells, so the packets of a batch do not go in its order but far apart from each
// other; the order changes no result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sw/facet/packet.h"
#include "sw/machine/word.h"

namespace rc2 {

class FeederWords {
 public:
  /// The words of feeder `feeder` (0 .. feeders-1). `packets` must outlive this.
  FeederWords(const facet::PacketStream& packets, int feeder, int feeders);

  bool done() const { return batch_ == batches_.size(); }

  /// The next word, only if not done: values stand at the first cell of the packet's box in the
  /// feeder's first row of it; rows are counted in the feeder's rows.
  Word next();

  /// Share of the packets gone through, 0 .. 1.
  double share() const;

 private:
  const facet::PacketHead& head() const;
  bool packets_left() const { return sent_ < batches_[batch_].count; }
  // Goes on, if need be, to a packet that has rows of this feeder, or to the end of an object.
  void settle();
  void begin_batch();
  void next_packet();
  Word head_word() const;
  Word linear_word(WordKind kind, const facet::Linear& value) const;

  const facet::PacketStream& packets_;
  std::vector<facet::Batch> batches_;
  int feeder_, feeders_;
  std::size_t batch_ = 0;
  // In the batch: packets gone through, the place of the one under way, from one to the next.
  std::size_t sent_ = 0, place_ = 0, stride_ = 0;
  std::uint32_t word_ = 0;  // of the packet; 0 is its HEAD
  int first_row_ = 0, rows_ = 0;
};

/// Words of a packet: HEAD, SLAB, its SIDEs, GAP.
std::int64_t words_of(const facet::PacketHead& packet);

/// Words of the feeder that has most: no machine loads the packets in fewer cycles.
std::int64_t busiest_feeder_words(const facet::PacketStream& packets, int feeders);

}  // namespace rc2
