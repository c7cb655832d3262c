#include "sw/golden/voxelise.h"

#include <array>

#include "sw/machine/claim.h"

namespace rc2::golden {
namespace {

// Up to so many voxels it is quicker to look at each than to find out which to look at.
constexpr int kSmallBox = 256;
constexpr std::uint32_t kFewSides = 8;

bool is_small(const facet::PacketHead& packet) {
  const glm::ivec3 size = packet.hi - packet.lo + 1;
  return std::int64_t{size.x} * size.y * size.z <= kSmallBox && packet.side_count <= kFewSides;
}

// Every voxel of the box against every bound, with no branch but those of the loops: a processor
// would guess most of them wrong.
void fill_small(Grid& grid, const facet::PacketHead& packet, const facet::Side* sides) {
  const glm::ivec3 size = packet.hi - packet.lo;
  const facet::Slab& slab = packet.slab;
  const int n = grid.n();
  std::array<std::int64_t, kFewSides> t;
  for (int y = 0; y <= size.y; ++y) {
    for (int x = 0; x <= size.x; ++x) {
      std::ptrdiff_t place = grid.index(packet.lo + glm::ivec3(x, y, 0));
      std::int64_t back = value_at(slab.value, x, y), gap = value_at(packet.gap, x, y);
      for (std::uint32_t i = 0; i < packet.side_count; ++i) t[i] = value_at(sides[i].value, x, y);
      for (int z = 0; z <= size.z; ++z) {
        // Negative if any of the bounds is.
        std::int64_t all = back | (slab.width - back), all_core = 0;
        for (std::uint32_t i = 0; i < packet.side_count; ++i) {
          all |= t[i];
          all_core |= t[i] - sides[i].push;
          t[i] += sides[i].value.c;
        }
        const Claim claim{packet.facet, all_core >= 0, gap_of(n, gap)};
        grid[place] = std::min(grid[place], all >= 0 ? claim.packed() : Grid::kFree);
        back += slab.value.c;
        gap += packet.gap.c;
        place += grid.stride(2);
      }
    }
  }
}

}  // namespace

void fill_facet(Grid& grid, const facet::PacketHead& packet, const facet::Side* sides) {
  if (is_small(packet)) {
    fill_small(grid, packet, sides);
    return;
  }
  const int n = grid.n();
  for_each_dexel(packet, sides, [&](const Dexel& dexel) {
    std::ptrdiff_t place = grid.index(packet.lo + glm::ivec3(dexel.x, dexel.y, dexel.z.first));
    for (std::int64_t z = dexel.z.first; z <= dexel.z.last; ++z) {
      grid[place] = std::min(grid[place], claim_of(n, packet, dexel, z).packed());
      place += grid.stride(2);
    }
  });
}

}  // namespace rc2::golden
