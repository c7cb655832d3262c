// Packets that no geometry made: boxes cut by random slabs and sides, of every layer. They meet
// values and combinations that facets never do.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <numeric>
#include <vector>

#include "sw/base/config.h"
#include "sw/facet/packet.h"
#include "tb/load/dice.h"

namespace rc2 {

using facet::Dice;

inline int pick(Dice& dice, int lowest, int highest) {
  return static_cast<int>(dice.roll(lowest, highest));
}

inline glm::ivec3 pick_voxel(Dice& dice, int n) {
  return {pick(dice, 0, n - 1), pick(dice, 0, n - 1), pick(dice, 0, n - 1)};
}

inline void add_packet(facet::PacketStream& stream, std::uint32_t number, glm::ivec3 lo,
                       glm::ivec3 hi, const facet::Slab& slab = {},
                       const std::vector<facet::Side>& sides = {}, const facet::Linear& gap = {}) {
  stream.heads.push_back({number, lo, hi, slab, gap,
                          static_cast<std::uint32_t>(stream.sides.size()),
                          static_cast<std::uint32_t>(sides.size())});
  stream.sides.insert(stream.sides.end(), sides.begin(), sides.end());
}

/// `count` packets with coefficients up to `scale`, at most 4^(l+f); their numbers do not follow
/// their order.
inline facet::PacketStream random_packets(Dice& dice, int n, int count, std::int64_t scale,
                                          int fraction_bits = 4) {
  const auto linear = [&](std::int64_t largest) {
    const auto coefficient = [&] { return dice.roll(-largest, largest); };
    facet::Linear value{coefficient(), coefficient(), coefficient(), n * coefficient() / 2};
    if (pick(dice, 0, 3) == 0) value.c = 0;
    return value;
  };
  const std::int64_t side_scale =
      std::min(scale, std::int64_t{1} << (coordinate_bits(n) + fraction_bits));
  const std::int64_t gap_scale = std::int64_t{1} << gap_fraction_bits(n);
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  dice.shuffle(numbers.begin(), numbers.end());
  facet::PacketStream stream;
  for (const std::uint32_t number : numbers) {
    const glm::ivec3 a = pick_voxel(dice, n), b = pick_voxel(dice, n);
    const facet::Slab slab{linear(scale), dice.roll(0, 3 * scale)};
    std::vector<facet::Side> sides;
    for (int k = pick(dice, 0, 5); k > 0; --k)
      sides.push_back({linear(side_scale), dice.roll(0, side_scale)});
    add_packet(stream, number, glm::min(a, b), glm::max(a, b), slab, sides,
               linear(pick(dice, 0, 2) == 0 ? 3 : gap_scale));
    stream.heads.back().surface = static_cast<facet::Surface>(pick(dice, 0, 2));
  }
  return stream;
}

/// The same in batches of one layer each, armour first, some of which end an object.
inline facet::PacketStream random_layers(Dice& dice, int n, int count, std::int64_t scale,
                                         int fraction_bits = 4) {
  facet::PacketStream stream = random_packets(dice, n, count, scale, fraction_bits);
  std::uint32_t first = 0;
  while (first < stream.heads.size()) {
    const auto left = static_cast<int>(stream.heads.size() - first);
    const auto size =
        static_cast<std::uint32_t>(first == 0 ? (left + 1) / 2 : pick(dice, 1, std::min(left, 5)));
    const auto layer = static_cast<facet::Layer>(first == 0 ? 0 : pick(dice, 1, 3));
    for (std::uint32_t i = 0; i < size; ++i) stream.heads[first + i].layer = layer;
    const bool ends = layer == facet::Layer::inside && pick(dice, 0, 3) != 0;
    stream.batches.push_back({first, size, ends});
    first += size;
  }
  return stream;
}

}  // namespace rc2
