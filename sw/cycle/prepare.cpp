#include "sw/cycle/prepare.h"

#include <algorithm>
#include <cstdlib>

#include "sw/cycle/cell.h"

namespace rc2::cycle {
namespace {

constexpr std::int64_t kStages = 2;  // of the unit, after the voxel's owner is asked for

// How far from the light the plane may be, to a column, in half sixteenths of a voxel.
constexpr int kDoubt = 4;

// From the far side of the owner's plane to this depth, in sixteenths of a voxel, light stops.
struct Depths {
  int first, last;
};

Depths guarded(const Owner& owner, const glm::ivec3& way, bool away, int n) {
  int step = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int part = owner.normal[axis];
    const bool deeper = way[axis] != 0 && part != 0 && ((part < 0) == (way[axis] < 0)) == away;
    if (deeper) step += std::abs(part);
  }
  const int first = owner.surface == facet::Surface::sheet ? 1 << (kGapFractionBits - 1) : 0;
  return {first, first + (step >> coordinate_bits(n)) + 1};
}

bool stops(const Owner& owner, bool occupied, const glm::ivec3& way, int n) {
  if (occupied && owner.surface == facet::Surface::crowd) return true;
  const int gap = owner.claim.gap;
  const int below = owner.normal.x * way.x + owner.normal.y * way.y + owner.normal.z * way.z;
  const bool away = (2 * gap + 1 + kDoubt) * (1 << (coordinate_bits(n) - 1)) < below;
  if (occupied && owner.surface == facet::Surface::solid) return away;
  const bool behind = (gap < 0) != away;
  const int depth = gap < 0 ? ~gap : gap;
  const Depths depths = guarded(owner, way, away, n);
  return behind && depth >= depths.first && (occupied || depth <= depths.last);
}

}  // namespace

std::int64_t prepare(const LightJob& light, int n, Columns& columns) {
  if (light.rule == LightRule::thesis) return 0;
  std::int64_t most = 0;
  const Columns& known = columns;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const VoxelBits& inside = known.layers(column).inside;
    for (int z = 0; z < inside.size(); ++z) {
      if (inside.has(z) && !columns.occupied(column, z)) columns.set_stop(column, z, true);
    }
    const auto cell = static_cast<int>(column);
    std::int64_t looked_at = 0;
    for (int z = columns.next_owned(column, 0); z < n; z = columns.next_owned(column, z + 1)) {
      ++looked_at;
      const bool occupied = columns.occupied(column, z);
      const glm::ivec3 way = glm::ivec3(cell % n, cell / n, z) - light.source;
      if (stops(columns.owner(column, z), occupied, way, n)) {
        columns.set_stop(column, z, true);
      } else if (occupied) {
        columns.set_stop(column, z, false);
      }
    }
    most = std::max(most, looked_at);
  }
  // The light's own voxel stops nothing: it may be a guard or inside a solid.
  columns.set_stop(cell_number(light.source.x, light.source.y, n), light.source.z, false);
  return most == 0 ? 0 : most + kStages;
}

}  // namespace rc2::cycle
