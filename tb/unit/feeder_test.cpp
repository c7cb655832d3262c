// The feeders together send every packet to each of its rows once, with the values that belong
// there, and never one packet's words among another's.
#include "sw/machine/feeder.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

namespace rc2 {
namespace {

using facet::Linear;
using facet::PacketStream;

PacketStream random_packets(std::mt19937& random, int n, int count) {
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const auto linear = [&] {
    return Linear{pick(-99, 99), pick(-99, 99), pick(-99, 99), pick(-9999, 9999)};
  };
  PacketStream stream;
  for (int i = 0; i < count; ++i) {
    facet::PacketHead head;
    head.facet = static_cast<std::uint32_t>(i);
    for (int axis = 0; axis < 3; ++axis) {
      head.lo[axis] = pick(0, n - 1);
      head.hi[axis] = pick(head.lo[axis], n - 1);
    }
    head.slab = {linear(), pick(0, 99)};
    head.gap = linear();
    head.first_side = static_cast<std::uint32_t>(stream.sides.size());
    head.side_count = static_cast<std::uint32_t>(pick(0, 5));
    for (std::uint32_t k = 0; k < head.side_count; ++k)
      stream.sides.push_back({linear(), pick(0, 99)});
    stream.heads.push_back(head);
  }
  return stream;
}

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

TEST(FeederWords, ReachEveryRowOfEveryPacketOnce) {
  std::mt19937 random(1);
  for (const int n : {1, 2, 5, 16}) {
    for (int feeders = 1; feeders <= n; feeders *= 2) {
      for (const int count : {0, 1, 2, 3, 50}) {
        const PacketStream stream = random_packets(random, n, count);
        std::map<std::pair<std::uint32_t, int>, Seen> seen;  // of facet and row
        std::int64_t busiest = 0;
        for (int k = 0; k < feeders; ++k) {
          FeederWords words(stream, k, feeders);
          Word head{WordKind::data};
          std::int64_t sent = 0;
          for (; !words.done(); ++sent) {
            const Word word = words.next();
            if (word.kind == WordKind::head) {
              ASSERT_TRUE(head.kind == WordKind::data) << "a packet in a packet";
              head = word;
              const facet::PacketHead& packet = stream.heads[word.facet];
              EXPECT_EQ(word.skip[0], packet.lo.x);
              EXPECT_EQ(word.skip[0] + word.take[0] - 1, packet.hi.x);
              EXPECT_EQ(word.z0, packet.lo.z);
              EXPECT_EQ(word.z0 + word.z_span, packet.hi.z);
            }
            for (int i = 0; i < head.take[1]; ++i) {
              const int row = (head.skip[1] + i) * feeders + k;
              seen[{head.facet, row}].emplace_back(word.kind, word.d + word.step[1] * feeders * i,
                                                   word.step[0], word.c, word.reach);
            }
            if (word.kind == WordKind::gap) head.kind = WordKind::data;
          }
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
