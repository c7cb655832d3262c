#include "sw/golden/voxelise.h"

#include <algorithm>

namespace rc2::golden {
namespace {

// Inclusive; empty when first > last.
struct Interval {
  std::int64_t first, last;
};

// Cuts an interval that is not empty to the z where t + c*z >= 0. The quotients have a numerator
// that is not negative, so that C++'s division, which rounds towards zero, rounds down.
void clip(Interval& z, std::int64_t t, std::int64_t c) {
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

}  // namespace

void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Bound* bounds) {
  const glm::ivec3 size = packet.hi - packet.lo;
  const facet::Bound* const end = bounds + packet.bound_count;
  for (int y = 0; y <= size.y; ++y) {
    for (int x = 0; x <= size.x; ++x) {
      Interval z{0, size.z};
      for (const facet::Bound* bound = bounds; bound != end && z.first <= z.last; ++bound) {
        clip(z, bound->a * x + bound->b * y + bound->d, bound->c);
      }
      std::ptrdiff_t place = grid.index(packet.lo + glm::ivec3(x, y, z.first));
      for (; z.first <= z.last; ++z.first, place += grid.stride(2)) {
        grid[place] = std::min(grid[place], packet.facet);
      }
    }
  }
}

}  // namespace rc2::golden
