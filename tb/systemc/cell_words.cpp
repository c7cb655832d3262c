#include "tb/systemc/cell_words.h"

#include <algorithm>

namespace rc2::tb {

std::vector<Word> words_before(int x, int y, const facet::PacketHead& packet,
                               const facet::Side* sides) {
  if (y < packet.lo.y || y > packet.hi.y || x > packet.hi.x) return {};
  const int first = std::max(x, packet.lo.x);  // the next cell that the packet serves
  const auto linear = [&](WordKind kind, const facet::Linear& value) {
    Word word{kind};
    word.step = {value.a, value.b};
    word.c = value.c;
    word.d = value.d + value.a * (first - packet.lo.x) + value.b * (y - packet.lo.y);
    return word;
  };
  Word head{WordKind::head};
  head.layer = packet.layer;
  head.facet = packet.facet;
  head.z0 = packet.lo.z;
  head.z_span = packet.hi.z - packet.lo.z;
  head.skip[0] = first - x;
  head.take[0] = packet.hi.x - first + 1;
  head.reach = packet.slab.width;
  std::vector<Word> words{head, linear(WordKind::slab, packet.slab.value)};
  for (std::uint32_t i = 0; i < packet.side_count; ++i) {
    words.push_back(linear(WordKind::side, sides[i].value));
    words.back().reach = sides[i].push;
  }
  words.push_back(linear(WordKind::gap, packet.gap));
  words.back().surface = packet.surface;
  return words;
}

}  // namespace rc2::tb
