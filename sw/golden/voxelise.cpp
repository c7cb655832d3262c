#include "sw/golden/voxelise.h"

#include "sw/machine/claim.h"

namespace rc2::golden {

void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Side* sides) {
  for_each_dexel(packet, sides, [&](const Dexel& dexel) {
    const auto& [x, y, z, core] = dexel;
    std::int64_t gap = value_at(packet.gap, x, y) + packet.gap.c * z.first;
    std::ptrdiff_t place = grid.index(packet.lo + glm::ivec3(x, y, z.first));
    for (std::int64_t at = z.first; at <= z.last; ++at) {
      const bool in_core = core.first <= at && at <= core.last;
      const Claim claim{packet.facet, in_core, gap_of(grid.n(), gap)};
      grid[place] = std::min(grid[place], claim.packed());
      gap += packet.gap.c;
      place += grid.stride(2);
    }
  });
}

}  // namespace rc2::golden
