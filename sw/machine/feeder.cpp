#include "sw/machine/feeder.h"

#include <algorithm>
#include <numeric>

namespace rc2 {
namespace {

// Near the golden section of the count, so that any few packets in a row are far apart; coprime to
// it, so that every packet has its turn.
std::size_t spreading_stride(std::size_t count) {
  std::size_t stride = count * 618 / 1000;
  while (std::gcd(stride, count) > 1) ++stride;
  return stride;
}

std::vector<facet::Batch> batches_of(const facet::PacketStream& packets) {
  if (!packets.batches.empty() || packets.heads.empty()) return packets.batches;
  return {{0, static_cast<std::uint32_t>(packets.heads.size()), false}};
}

}  // namespace

FeederWords::FeederWords(const facet::PacketStream& packets, int feeder, int feeders)
    : packets_(packets), batches_(batches_of(packets)), feeder_(feeder), feeders_(feeders) {
  begin_batch();
  settle();
}

const facet::PacketHead& FeederWords::head() const {
  return packets_.heads[batches_[batch_].first + place_];
}

void FeederWords::begin_batch() {
  sent_ = place_ = 0;
  if (!done()) stride_ = spreading_stride(batches_[batch_].count);
}

void FeederWords::settle() {
  while (!done()) {
    if (packets_left()) {
      first_row_ = head().lo.y + (feeder_ - head().lo.y % feeders_ + feeders_) % feeders_;
      if (first_row_ <= head().hi.y) {
        rows_ = (head().hi.y - first_row_) / feeders_ + 1;
        return;
      }
      next_packet();
    } else if (batches_[batch_].ends_object) {
      return;
    } else {
      ++batch_;
      begin_batch();
    }
  }
}

void FeederWords::next_packet() {
  ++sent_;
  place_ = (place_ + stride_) % batches_[batch_].count;
}

Word FeederWords::next() {
  if (!packets_left()) {
    ++batch_;
    begin_batch();
    settle();
    return Word{WordKind::end};
  }
  const facet::PacketHead& packet = head();
  const std::uint32_t position = word_++;
  if (position == 0) return head_word();
  if (position == 1) return linear_word(WordKind::slab, packet.slab.value);
  if (position < 2 + packet.side_count) {
    const facet::Side& side = packets_.sides[packet.first_side + position - 2];
    Word word = linear_word(WordKind::side, side.value);
    word.reach = side.push;
    return word;
  }
  Word word = linear_word(WordKind::gap, packet.gap);
  word.surface = packet.surface;
  word_ = 0;
  next_packet();
  settle();
  return word;
}

Word FeederWords::head_word() const {
  const facet::PacketHead& packet = head();
  Word word{WordKind::head};
  word.layer = packet.layer;
  word.facet = packet.facet;
  word.z0 = packet.lo.z;
  word.z_span = packet.hi.z - packet.lo.z;
  word.skip = {packet.lo.x, first_row_ / feeders_};
  word.take = {packet.hi.x - packet.lo.x + 1, rows_};
  word.reach = packet.slab.width;
  return word;
}

Word FeederWords::linear_word(WordKind kind, const facet::Linear& value) const {
  Word word{kind};
  word.step = {value.a, value.b};
  word.c = value.c;
  word.d = value.d + value.b * (first_row_ - head().lo.y);
  return word;
}

double FeederWords::share() const {
  const std::size_t gone = done() ? packets_.heads.size() : batches_[batch_].first + sent_;
  return static_cast<double>(gone) / static_cast<double>(packets_.heads.size());
}

std::int64_t words_of(const facet::PacketHead& packet) {
  return 3 + std::int64_t{packet.side_count};
}

std::int64_t busiest_feeder_words(const facet::PacketStream& packets, int feeders) {
  std::vector<std::int64_t> words(static_cast<std::size_t>(feeders));
  for (const facet::PacketHead& head : packets.heads) {
    const int rows = std::min(feeders, head.hi.y - head.lo.y + 1);
    for (int k = 0; k < rows; ++k) {
      words[static_cast<std::size_t>((head.lo.y + k) % feeders)] += words_of(head);
    }
  }
  const auto ends = std::count_if(packets.batches.begin(), packets.batches.end(),
                                  [](const facet::Batch& batch) { return batch.ends_object; });
  return *std::max_element(words.begin(), words.end()) + ends;
}

}  // namespace rc2
