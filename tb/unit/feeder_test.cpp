// The feeders together send every packet to each of its rows once, with the values that belong
// there, and never one packet's words among another's.
#include "sw/machine/feeder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "tb/unit/random_packets.h"

namespace rc2 {
namespace {

using facet::Linear;
using facet::PacketStream;

// What row `row` sees at its first cell: kind, d there, step, c and reach of each word.
using Seen =
    std::vector<std::tuple<WordKind, std::int64_t, std::int64_t, std::int64_t, std::int64_t>>;

Seen expected_at(const PacketStream& stream, const facet::PacketHead& head, int row) {
  Seen seen{{WordKind::head, 0, 0, 0, head.slab.width}};
  const auto see = [&](WordKind kind, const Linear& value, std::int64_t reach) {
    seen.emplace_back(kind, value.d + value.b * (row - head.lo.y), value.a, value.c, reach);
  };
  see(WordKind::slab, head.slab.value, 0);
  for (std::uint32_t k = 0; k < head.side_count; ++k) {
    const facet::Side& side = stream.sides[head.first_side + k];
    see(WordKind::side, side.value, side.push);
  }
  see(WordKind::gap, head.gap, 0);
  return seen;
}

// What one feeder sends, taken apart.
class Listener {
 public:
  Listener(const PacketStream& stream, int feeder, int feeders)
      : stream_(stream), feeder_(feeder), feeders_(feeders) {
    for (std::size_t i = 0; i < stream.heads.size(); ++i) places_[stream.heads[i].facet] = i;
  }

  void hear(const Word& word, std::map<std::pair<std::uint32_t, int>, Seen>& seen) {
    if (word.kind == WordKind::head) begin(word);
    if (word.kind == WordKind::end) {
      ASSERT_FALSE(within_) << "an end in a packet";
      while (!stream_.batches[batch_].ends_object) ++batch_;
      ++batch_;
      return;
    }
    ASSERT_TRUE(within_) << "a word without a packet";
    for (int i = 0; i < head_.take[1]; ++i) {
      const int row = (head_.skip[1] + i) * feeders_ + feeder_;
      seen[{head_.facet, row}].emplace_back(word.kind, word.d + word.step[1] * feeders_ * i,
                                            word.step[0], word.c, word.reach);
    }
    within_ = word.kind != WordKind::gap;
  }

  /// Whether every object that ends was told so.
  bool is_through() const {
    return std::none_of(stream_.batches.begin() + static_cast<std::ptrdiff_t>(batch_),
                        stream_.batches.end(),
                        [](const facet::Batch& batch) { return batch.ends_object; });
  }

 private:
  void begin(const Word& word) {
    ASSERT_FALSE(within_) << "a packet in a packet";
    within_ = true;
    head_ = word;
    const std::size_t place = places_.at(word.facet);
    const facet::PacketHead& packet = stream_.heads[place];
    EXPECT_EQ(word.layer, packet.layer);
    EXPECT_EQ(word.skip[0], packet.lo.x);
    EXPECT_EQ(word.skip[0] + word.take[0] - 1, packet.hi.x);
    EXPECT_EQ(word.z0, packet.lo.z);
    EXPECT_EQ(word.z0 + word.z_span, packet.hi.z);
    // Only the end of an object may carry us past its batch.
    while (place >= stream_.batches[batch_].first + stream_.batches[batch_].count) {
      ASSERT_FALSE(stream_.batches[batch_].ends_object) << "an object without an end";
      ++batch_;
    }
    EXPECT_GE(place, stream_.batches[batch_].first) << "a batch goes before another has gone";
  }

  const PacketStream& stream_;
  int feeder_, feeders_;
  std::map<std::uint32_t, std::size_t> places_;
  std::size_t batch_ = 0;
  bool within_ = false;
  Word head_{WordKind::head};
};

TEST(FeederWords, ReachEveryRowOfEveryPacketOnceAndInTheOrderOfBatches) {
  Dice dice(1);
  for (const int n : {2, 5, 16}) {
    for (int feeders = 1; feeders <= n; feeders *= 2) {
      for (const int count : {0, 1, 2, 3, 50}) {
        const PacketStream stream = random_layers(dice, n, count, 99);
        std::map<std::pair<std::uint32_t, int>, Seen> seen;  // of facet and row
        std::int64_t busiest = 0;
        for (int k = 0; k < feeders; ++k) {
          FeederWords words(stream, k, feeders);
          Listener listener(stream, k, feeders);
          std::int64_t sent = 0;
          for (; !words.done(); ++sent) ASSERT_NO_FATAL_FAILURE(listener.hear(words.next(), seen));
          EXPECT_TRUE(listener.is_through());
          busiest = std::max(busiest, sent);
        }
        std::size_t rows = 0;
        for (const auto& head : stream.heads) {
          for (int row = head.lo.y; row <= head.hi.y; ++row, ++rows) {
            EXPECT_EQ((seen[{head.facet, row}]), expected_at(stream, head, row));
          }
        }
        EXPECT_EQ(seen.size(), rows) << "a row outside a box was served";
        EXPECT_EQ(busiest_feeder_words(stream, feeders), busiest);
      }
    }
  }
}

}  // namespace
}  // namespace rc2
