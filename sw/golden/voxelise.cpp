#include "sw/golden/voxelise.h"

#include <algorithm>

#include "sw/machine/claim.h"

namespace rc2::golden {
namespace {

// Inclusive; empty when first > last.
struct Interval {
  std::int64_t first, last;
};

// Cuts an interval to the z where t + c*z >= 0. The quotients have a numerator that is not
// negative, so that C++'s division, which rounds towards zero, rounds down.
void clip(Interval& z, std::int64_t t, std::int64_t c) {
  if (z.first > z.last) return;
  const bool holds_at_zero = t >= 0;
  const bool holds_at_last = t + c * z.last >= 0;
  if (!holds_at_zero && !holds_at_last) {
    z.last = -1;
  } else if (!holds_at_zero) {
    z.first = std::max(z.first, (-t - 1) / c + 1);
  } else if (!holds_at_last) {
    z.last = t / -c;
  }
}

std::int64_t value_at(const facet::Linear& value, int x, int y) {
  return value.a * x + value.b * y + value.d;
}

}  // namespace

void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Side* sides) {
  const glm::ivec3 size = packet.hi - packet.lo;
  const facet::Slab& slab = packet.slab;
  for (int y = 0; y <= size.y; ++y) {
    for (int x = 0; x <= size.x; ++x) {
      Interval z{0, size.z}, core{0, size.z};
      const std::int64_t back = value_at(slab.value, x, y);
      clip(z, back, slab.value.c);
      clip(z, slab.width - back, -slab.value.c);
      for (std::uint32_t i = 0; i < packet.side_count && z.first <= z.last; ++i) {
        const std::int64_t t = value_at(sides[i].value, x, y);
        clip(z, t, sides[i].value.c);
        clip(core, t - sides[i].push, sides[i].value.c);
      }
      std::int64_t gap = value_at(packet.gap, x, y) + packet.gap.c * z.first;
      std::ptrdiff_t place = grid.index(packet.lo + glm::ivec3(x, y, z.first));
      for (; z.first <= z.last; ++z.first, gap += packet.gap.c, place += grid.stride(2)) {
        const bool in_core = core.first <= z.first && z.first <= core.last;
        const Claim claim{packet.facet, in_core, gap_of(grid.n(), gap)};
        grid[place] = std::min(grid[place], claim.packed());
      }
    }
  }
}

}  // namespace rc2::golden
