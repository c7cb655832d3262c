#include "sw/golden/voxelise.h"

#include <array>

#include "sw/machine/claim.h"

namespace rc2::golden {
namespace {

// The claims of one packet. As gap_of(), but looks up a gap's width once and not for every voxel.
class Claims {
 public:
  Claims(const facet::PacketHead& packet, int n)
      : facet_(packet.facet), dropped_(gap_fraction_bits(n) - kGapFractionBits) {}

  std::uint32_t packed(std::int64_t gap, bool core) const {
    constexpr int kSign = 1 << (kGapBits - 1);
    const int low = static_cast<int>(gap >> dropped_ & (2 * kSign - 1));
    return Claim{facet_, core, (low ^ kSign) - kSign}.packed();
  }

 private:
  std::uint32_t facet_;
  int dropped_;
};

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
  const Claims claims(packet, grid.n());
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
        const std::uint32_t claim = claims.packed(gap, all_core >= 0);
        grid[place] = std::min(grid[place], all >= 0 ? claim : Grid::kFree);
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
  const Claims claims(packet, grid.n());
  for_each_dexel(packet, sides, [&](const Dexel& dexel) {
    const auto& [x, y, z, core] = dexel;
    std::int64_t gap = value_at(packet.gap, x, y) + packet.gap.c * z.first;
    std::ptrdiff_t place = grid.index(packet.lo + glm::ivec3(x, y, z.first));
    for (std::int64_t at = z.first; at <= z.last; ++at) {
      const bool in_core = core.first <= at && at <= core.last;
      grid[place] = std::min(grid[place], claims.packed(gap, in_core));
      gap += packet.gap.c;
      place += grid.stride(2);
    }
  });
}

}  // namespace rc2::golden
