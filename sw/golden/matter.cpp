#include "sw/golden/matter.h"

#include <cstdlib>

namespace rc2::golden {
namespace {

// An eighth of a voxel, in half sixteenths: so far from the light the plane may be, to a column.
constexpr int kDoubt = 4;

// Where light is stopped behind a sheet begins half a voxel from its plane, in units of a gap.
constexpr int kHalfVoxel = 1 << (kGapFractionBits - 1);

// A voxel and its plane, as the light sees them.
class View {
 public:
  View(const glm::ivec3& source, const glm::ivec3& voxel, const Claim& claim, const Plane& plane,
       int n)
      : way_(voxel - source), claim_(claim), plane_(plane), n_(n) {
    // The middle of the sixteenth that the gap was rounded down to, and what it may be wrong by.
    const int gap = (2 * claim.gap + 1 + kDoubt) * (1 << (coordinate_bits(n) - 1));
    const glm::ivec3 rise = plane.normal * way_;
    turned_away_ = gap < rise.x + rise.y + rise.z;
  }

  Matter armour() const {
    switch (plane_.surface) {
      case facet::Surface::solid:
        return turned_away_ ? Matter::stop : Matter::pass;
      case facet::Surface::sheet:
        return is_behind() && depth() >= kHalfVoxel ? Matter::stop : Matter::pass;
      default:
        return Matter::stop;
    }
  }

  Matter guard() const {
    const int first = plane_.surface == facet::Surface::sheet ? kHalfVoxel : 0;
    const bool stops = is_behind() && depth() >= first && depth() <= first + longest_step();
    return stops ? Matter::solid : Matter::free;
  }

 private:
  // Beyond the plane, as a ray from the light comes.
  bool is_behind() const { return (claim_.gap < 0) != turned_away_; }
  int depth() const { return claim_.gap < 0 ? ~claim_.gap : claim_.gap; }

  // How much deeper one step can bring a ray here; rounded up, because a depth is rounded down.
  int longest_step() const {
    int sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int rise = plane_.normal[axis] * way_[axis];
      if (turned_away_ ? rise > 0 : rise < 0) sum += std::abs(plane_.normal[axis]);
    }
    return (sum >> (normal_fraction_bits(n_) - kGapFractionBits)) + 1;
  }

  glm::ivec3 way_;  // from the light
  Claim claim_;
  const Plane& plane_;
  int n_;
  bool turned_away_;
};

}  // namespace

std::vector<Matter> look_from(const LightJob& job, const Grid& grid, const VoxelMemory& voxels,
                              const Layers& layers) {
  const bool accurate = job.rule == LightRule::accurate;
  const auto view = [&](const glm::ivec3& at, const Claim& claim) {
    return View(job.source, at, claim, layers.plane(claim.facet), grid.n());
  };
  std::vector<Matter> field(grid.size(), Matter::outside);
  for (glm::ivec3 at{0}; at.z < grid.n(); ++at.z) {
    for (at.y = 0; at.y < grid.n(); ++at.y) {
      for (at.x = 0; at.x < grid.n(); ++at.x) {
        const std::ptrdiff_t place = grid.index(at);
        Matter& here = field[static_cast<std::size_t>(place)];
        here = grid[place] == Grid::kFree ? Matter::free : Matter::stop;
        if (!accurate) continue;
        if (here == Matter::stop) {
          here = view(at, voxels[grid[place]].owner).armour();
        } else if (layers.is_inside(at)) {
          here = Matter::solid;
        } else if (const auto guard = layers.guard(at)) {
          here = view(at, *guard).guard();
        }
      }
    }
  }
  return field;
}

}  // namespace rc2::golden
