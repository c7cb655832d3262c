#include "tb/stress/light_oracle.h"

#include <glm/common.hpp>

#include "sw/base/floor_divide.h"

namespace rc2::stress {
namespace {

// Targets of one axis whose rays are at the same offsets after 1, 2, ... steps.
struct Alike {
  std::vector<int> offsets;
  std::int64_t targets;
};

// The integer nearest to target * step / distance, ties down.
int offset_of(std::int64_t target, std::int64_t step, std::int64_t distance) {
  return static_cast<int>(floor_divide(2 * target * step + distance - 1, 2 * distance));
}

// All targets of -most .. most. Alike ones follow each other, because offsets grow with targets.
std::vector<Alike> alike_targets(int most, int distance, int steps) {
  std::vector<Alike> all;
  std::vector<int> offsets(static_cast<std::size_t>(steps));
  for (int target = -most; target <= most; ++target) {
    for (int step = 1; step <= steps; ++step)
      offsets[static_cast<std::size_t>(step) - 1] = offset_of(target, step, distance);
    if (all.empty() || all.back().offsets != offsets) all.push_back({offsets, 0});
    ++all.back().targets;
  }
  return all;
}

}  // namespace

LightOracle::LightOracle(int n, const VoxelMemory& voxels, const LayerMemory& layers,
                         const facet::PacketStream& packets)
    : n_(n),
      count_(voxels.size()),
      voxels_(static_cast<std::size_t>(n) * n * n),
      accurate_(n, voxels, layers, packets) {
  std::uint32_t number = 0;
  for (const VoxelRecord& record : voxels) {
    Voxel& voxel = at_voxel(record.at);
    voxel.armour = true;
    voxel.number = number++;
  }
  for (const LayerRecord& record : layers) at_voxel(record.at).inside = record.inside;
}

ExpectedLight LightOracle::light(const LightJob& job) const {
  ExpectedLight expected;
  expected.arrived.resize(count_);
  const std::vector<bool> stops = find_stops(job);
  const int distance = job.target_distance;
  const std::vector<Alike> wide = alike_targets(distance, distance, n_);
  const std::vector<Alike> narrow = alike_targets(distance - 1, distance, n_);
  Ray ray;
  for (int axis = 0; axis < 3; ++axis) {
    // A target on an edge is counted on the first of its faces: x before y before z.
    const int u_axis = axis == 0 ? 1 : 0, v_axis = axis == 2 ? 1 : 2;
    for (const Alike& u : u_axis < axis ? narrow : wide) {
      for (const Alike& v : v_axis < axis ? narrow : wide) {
        for (const int side : {-1, 1}) {
          ray.clear();
          for (int step = 1; step <= n_; ++step) {
            glm::ivec3 at = job.source;
            at[axis] += side * step;
            at[u_axis] += u.offsets[static_cast<std::size_t>(step) - 1];
            at[v_axis] += v.offsets[static_cast<std::size_t>(step) - 1];
            if (glm::clamp(at, 0, n_ - 1) != at) break;
            ray.push_back(at);
          }
          const std::int64_t targets = u.targets * v.targets;
          expected.targets.total += targets;
          bool is_home = false;
          for (std::size_t i = 0; i < ray.size() && !is_home; ++i) {
            is_home = stops[place(ray[i])];
            expected.visits += targets;
            const Voxel& voxel = at_voxel(ray[i]);
            if (!voxel.armour) {
              expected.guarded += is_home ? targets : 0;
              continue;
            }
            expected.arrived[voxel.number] += static_cast<std::uint32_t>(targets);
            expected.passed += is_home || i + 1 == ray.size() ? 0 : targets;
          }
          (is_home ? expected.targets.absorbed : expected.targets.escaped) += targets;
        }
      }
    }
  }
  return expected;
}

std::vector<bool> LightOracle::find_stops(const LightJob& job) const {
  std::vector<bool> stops(voxels_.size());
  for (glm::ivec3 at(0); at.z < n_; ++at.z)
    for (at.y = 0; at.y < n_; ++at.y)
      for (at.x = 0; at.x < n_; ++at.x)
        stops[place(at)] =
            job.rule == LightRule::thesis ? at_voxel(at).armour : accurate_.stops(at, job.source);
  return stops;
}

}  // namespace rc2::stress
