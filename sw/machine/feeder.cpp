#include "sw/machine/feeder.h"

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

}  // namespace

FeederWords::FeederWords(const facet::PacketStream& packets, int feeder, int feeders)
    : packets_(packets),
      feeder_(feeder),
      feeders_(feeders),
      stride_(spreading_stride(packets.heads.size())) {
  find_packet();
}

void FeederWords::find_packet() {
  for (; !done(); next_packet()) {
    first_row_ = head().lo.y + (feeder_ - head().lo.y % feeders_ + feeders_) % feeders_;
    if (first_row_ > head().hi.y) continue;
    rows_ = (head().hi.y - first_row_) / feeders_ + 1;
    return;
  }
}

void FeederWords::next_packet() {
  ++sent_;
  packet_ = (packet_ + stride_) % packets_.heads.size();
}

Word FeederWords::next() {
  const facet::PacketHead& head = this->head();
  const std::uint32_t position = word_++;
  if (position == 0) {
    Word word{WordKind::head};
    word.facet = head.facet;
    word.z0 = head.lo.z;
    word.z_span = head.hi.z - head.lo.z;
    word.skip = {head.lo.x, first_row_ / feeders_};
    word.take = {head.hi.x - head.lo.x + 1, rows_};
    word.reach = head.slab.width;
    return word;
  }
  if (position == 1) return linear_word(WordKind::slab, head.slab.value);
  if (position < 2 + head.side_count) {
    const facet::Side& side = packets_.sides[head.first_side + position - 2];
    Word word = linear_word(WordKind::side, side.value);
    word.reach = side.push;
    return word;
  }
  const Word word = linear_word(WordKind::gap, head.gap);
  word_ = 0;
  next_packet();
  find_packet();
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
  return static_cast<double>(sent_) / static_cast<double>(packets_.heads.size());
}

}  // namespace rc2
