#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>

#include "sw/facet/packet.h"
#include "sw/golden/grid.h"

namespace rc2::golden {

/// Inclusive; empty when first > last.
struct Interval {
  std::int64_t first, last;

  // Cuts the interval to the z where t + c*z >= 0. The quotients have a numerator that is not
  // negative, so that C++'s division, which rounds towards zero, rounds down.
  void clip(std::int64_t t, std::int64_t c) {
    if (first > last) return;
    const bool holds_at_zero = t >= 0;
    const bool holds_at_last = t + c * last >= 0;
    if (!holds_at_zero && !holds_at_last) {
      last = -1;
    } else if (!holds_at_zero) {
      first = std::max(first, (-t - 1) / c + 1);
    } else if (!holds_at_last) {
      last = t / -c;
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
  const facet::Slab& slab = packet.slab;
  for (int y = 0; y <= size.y; ++y) {
    for (int x = 0; x <= size.x; ++x) {
      Interval z{0, size.z}, core{0, size.z};
      const std::int64_t back = value_at(slab.value, x, y);
      z.clip(back, slab.value.c);
      if (packet.layer != facet::Layer::inside) z.clip(slab.width - back, -slab.value.c);
      for (std::uint32_t i = 0; i < packet.side_count && z.first <= z.last; ++i) {
        const std::int64_t t = value_at(sides[i].value, x, y);
        z.clip(t, sides[i].value.c);
        core.clip(t - sides[i].push, sides[i].value.c);
      }
      if (z.first <= z.last) visit(Dexel{x, y, z, core});
    }
  }
}

/// Fills the voxels of one facet. The grid keeps the best packed Claim to each voxel, in whatever
/// order facets come. `sides` are the sides of this packet.
void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Side* sides);

}  // namespace rc2::golden
