#include "tb/load/machine_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>

#include "sw/base/config.h"
#include "tb/load/column_oracle.h"

namespace rc2::facet {
namespace {

bool are_apart(const VoxelBox& a, const VoxelBox& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return true;
  return false;
}

// For each voxel the facets that have it.
class Expected {
 public:
  Expected(const std::vector<Border>& borders, const Cube& cube, Rule rule) : n_(cube.n) {
    columns_.resize(borders.size());
    boxes_.resize(borders.size());
    occupied_.resize(static_cast<std::size_t>(n_) * n_ * n_);
    for (std::size_t i = 0; i < borders.size(); ++i) {
      const VoxelBox& box = boxes_[i] = voxels_around(borders[i], cube, 2);
      const ColumnOracle<Int128> oracle(borders[i], cube.one(), rule);
      for (int y = box.low.y; y <= box.high.y; ++y)
        for (int x = box.low.x; x <= box.high.x; ++x) {
          const Column column = oracle.column(x, y, n_);
          columns_[i].push_back(column);
          for (int z = column.voxels.first; z <= column.voxels.last; ++z) {
            auto&& voxel = occupied_[(static_cast<std::size_t>(z) * n_ + y) * n_ + x];
            count_ += voxel ? 0 : 1;
            voxel = true;
          }
        }
    }
  }

  std::int64_t count() const { return count_; }

  bool has(std::size_t facet, const glm::ivec3& at) const {
    return holds(column(facet, at).voxels, at.z);
  }
  bool has_in_core(std::size_t facet, const glm::ivec3& at) const {
    return holds(column(facet, at).core, at.z);
  }
  bool has_in_any_core(const glm::ivec3& at) const {
    for (std::size_t facet = 0; facet < columns_.size(); ++facet)
      if (has_in_core(facet, at)) return true;
    return false;
  }

 private:
  static bool holds(const Span& span, int z) { return span.first <= z && z <= span.last; }

  Column column(std::size_t facet, const glm::ivec3& at) const {
    const VoxelBox& box = boxes_[facet];
    if (at.x < box.low.x || at.y < box.low.y || at.x > box.high.x || at.y > box.high.y)
      return {{0, -1}, {0, -1}};
    const int width = box.high.x - box.low.x + 1;
    return columns_[facet][static_cast<std::size_t>(at.y - box.low.y) * width + at.x - box.low.x];
  }

  int n_;
  std::vector<VoxelBox> boxes_;
  std::vector<std::vector<Column>> columns_;
  std::vector<bool> occupied_;
  std::int64_t count_ = 0;
};

// Whether the gap is the voxel centre's distance from the plane in sixteenths of a voxel, rounded
// down from at most 3/8 beside the truth.
bool is_gap(int gap, const Border& border, const Cube& cube, const glm::ivec3& at) {
  const Vertex normal = doubled_area(border);
  const std::int64_t size = std::abs(normal[dominant_axis(normal)]) * cube.one(), eight = 8;
  const std::int64_t eighths = eight * 16 * dot(normal, Vertex(at) * cube.one() - border[0]);
  return eight * gap * size <= eighths + 3 * size && eighths - 3 * size < eight * (gap + 1) * size;
}

}  // namespace

std::vector<Border> draw_apart(std::uint64_t seed, std::int64_t number, const Cube& cube, int cases,
                               int apart) {
  std::vector<Border> chosen;
  std::vector<VoxelBox> taken;
  Dice dice(Dice(seed).bits() ^ Dice(static_cast<std::uint64_t>(number)).bits());
  for (int i = 0; i < cases; ++i) {
    const auto kind = kFacetClasses[(static_cast<std::size_t>(number) + i) % kFacetClasses.size()];
    const std::vector<Border> drawn = generate_facets(kind, cube, dice.bits());
    VoxelBox box = voxels_around(drawn[0], cube, apart);
    for (const Border& border : drawn) {
      const VoxelBox more = voxels_around(border, cube, apart);
      box = {glm::min(box.low, more.low), glm::max(box.high, more.high)};
    }
    if (!has_area(drawn[0]) || !std::all_of(taken.begin(), taken.end(), [&](const VoxelBox& other) {
          return are_apart(box, other);
        }))
      continue;
    taken.push_back(box);
    chosen.insert(chosen.end(), drawn.begin(), drawn.end());
  }
  return chosen;
}

int random_feeders(int n, Dice& dice) { return 1 << dice.roll(0, bits_for(n + 1) - 1); }

std::int64_t check_machines(const std::vector<Machine*>& machines,
                            const std::vector<Border>& borders, const Cube& cube, Rule rule) {
  const FacetSet set = build_facets(scene_of(borders, cube), cube.n, cube.fraction_bits, rule);
  VoxelMemory voxels;
  for (Machine* machine : machines) {
    machine->load(set.packets, nullptr);
    const VoxelMemory its = machine->read_voxels();
    if (machine == machines.front()) voxels = its;
    if (!(its == voxels)) throw Difference("two machines differ");
  }

  // The host numbers only the facets that it loads.
  std::vector<Border> loaded;
  for (const Border& border : borders)
    if (!build_facets(scene_of({border}, cube), cube.n, cube.fraction_bits, rule)
             .packets.heads.empty())
      loaded.push_back(border);
  if (loaded.size() != set.facets.size()) throw Difference("facets count for each other");
  const Expected expected(borders, cube, rule), by_number(loaded, cube, rule);
  for (const VoxelRecord& record : voxels) {
    const auto& [at, owner] = record;
    if (owner.facet >= loaded.size() || !by_number.has(owner.facet, at) ||
        owner.core != by_number.has_in_core(owner.facet, at) ||
        (!owner.core && by_number.has_in_any_core(at)) ||
        !is_gap(owner.gap, loaded[owner.facet], cube, at))
      throw Difference(fmt::format("facet {} should not own voxel ({}, {}, {}), or not like this",
                                   owner.facet, at.x, at.y, at.z));
  }
  const auto count = static_cast<std::int64_t>(voxels.size());
  if (count != expected.count())
    throw Difference(
        fmt::format("{} voxels are occupied, the oracle says {}", count, expected.count()));
  return count;
}

}  // namespace rc2::facet
