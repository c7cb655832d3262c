#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>

#include "sw/facet/packet.h"
#include "sw/golden/grid.h"
#include "sw/machine/claim.h"

namespace rc2::golden {

/// Inclusive; empty when first > last.
struct Interval {
  std::int64_t first, last;

  // Cuts the interval, which does not go below 0, to the i where t + c*i >= 0. Where it divides,
  // the numerator is not negative, so that C++'s division, which rounds towards zero, rounds down.
  void clip(std::int64_t t, std::int64_t c) {
    if (first > last) return;
    const bool holds_at_first = t + c * first >= 0;
    const bool holds_at_last = t + c * last >= 0;
    if (holds_at_first && holds_at_last) return;
    if (holds_at_first) {
      last = t / -c;
    } else if (holds_at_last) {
      first = (-t - 1) / c + 1;
    } else {
      last = first - 1;
    }
  }
};

/// What a facet fills of one column and what of the column its border holds, all counted from the
/// low corner of its box.
struct Dexel {
  int x, y;
  Interval z, core;
};

inline std::int64_t value_at(const facet::Linear& value, int x, int y) {
  return value.a * x + value.b * y + value.d;
}

/// Calls visit(dexel) for every column in which the facet fills a voxel of its box: one within its
/// slab and sides (thesis 3.7). `sides` are the sides of this packet.
template <typename Visit>
void for_each_dexel(const facet::PacketHead& packet, const facet::Side* sides, Visit visit) {
  const glm::ivec3 size = packet.hi - packet.lo;
  const facet::Side* const end = sides + packet.side_count;
  const facet::Linear& back = packet.slab.value;
  // Always holds where the slab has no front.
  const facet::Linear front =
      packet.layer == facet::Layer::inside
          ? facet::Linear{0, 0, 0, 0}
          : facet::Linear{-back.a, -back.b, -back.c, packet.slab.width - back.d};
  for (int y = 0; y <= size.y; ++y) {
    // The columns that no bound leaves empty, each taken where it is largest.
    Interval row{0, size.x};
    const auto cut_row = [&](const facet::Linear& value) {
      row.clip(value_at(value, 0, y) + std::max<std::int64_t>(0, value.c * size.z), value.a);
    };
    cut_row(back);
    cut_row(front);
    for (const facet::Side* side = sides; side != end; ++side) cut_row(side->value);
    for (int x = static_cast<int>(row.first); x <= row.last; ++x) {
      Interval z{0, size.z};
      z.clip(value_at(back, x, y), back.c);
      z.clip(value_at(front, x, y), front.c);
      Interval core = z;
      for (const facet::Side* side = sides; side != end && z.first <= z.last; ++side) {
        const std::int64_t t = value_at(side->value, x, y), c = side->value.c;
        z.clip(t, c);
        core.clip(t - side->push, c);
      }
      if (z.first <= z.last) visit(Dexel{x, y, z, core});
    }
  }
}

/// What the facet says of voxel z of a dexel's column.
inline Claim claim_of(int n, const facet::PacketHead& packet, const Dexel& dexel, std::int64_t z) {
  const std::int64_t gap = value_at(packet.gap, dexel.x, dexel.y) + packet.gap.c * z;
  return {packet.facet, dexel.core.first <= z && z <= dexel.core.last, gap_of(n, gap)};
}

/// Fills the voxels of one facet. The grid keeps the best packed Claim to each voxel, in whatever
/// order facets come. `sides` are the sides of this packet.
void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Side* sides);

}  // namespace rc2::golden
