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
    : n_(n), count_(voxels.size()), voxels_(static_cast<std::size_t>(n) * n * n) {
  std::uint32_t number = 0;
  for (const VoxelRecord& record : voxels) {
    Voxel& voxel = at_voxel(record.at);
    voxel.armour = true;
    voxel.number = number++;
    voxel.owner = record.owner;
  }
  for (const LayerRecord& record : layers) {
    at_voxel(record.at).inside = record.inside;
    at_voxel(record.at).thin = record.thin;
  }
  for (const facet::PacketHead& head : packets.heads) {
    if (head.layer != facet::Layer::armour) continue;
    if (facing_.size() <= head.facet) facing_.resize(head.facet + 1, kOppositeFacings / 2);
    facing_[head.facet] = head.facing;
  }
}

ExpectedLight LightOracle::light(const LightJob& job) const {
  ExpectedLight expected;
  expected.arrived.resize(count_);
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
          const Reach far = reach(ray, job);
          expected.targets.total += targets;
          (far.is_home ? expected.targets.absorbed : expected.targets.escaped) += targets;
          expected.visits += targets * static_cast<std::int64_t>(far.count);
          for (std::size_t i = 0; i < far.count; ++i) {
            const Voxel& voxel = at_voxel(ray[i]);
            if (!voxel.armour) continue;
            expected.arrived[voxel.number] += static_cast<std::uint32_t>(targets);
            if (i + 1 < far.count) expected.passed += targets;
          }
        }
      }
    }
  }
  return expected;
}

namespace {

bool blocks(const LightJob& job, const Claim& owner) { return (*job.blocking)[owner.facet]; }

bool is_in_front(const LightJob& job, const Claim& owner) {
  return (owner.gap >= 0) == !blocks(job, owner);
}

}  // namespace

Reach LightOracle::reach(const Ray& ray, const LightJob& job) const {
  for (std::size_t i = 0; i < ray.size(); ++i) {
    const Voxel& voxel = at_voxel(ray[i]);
    bool ends = false;
    if (job.rule == LightRule::thesis) {
      ends = voxel.armour;
    } else if (!voxel.armour) {
      ends = voxel.inside || came_through(ray, i, job);
    } else if (!voxel.thin) {
      ends = blocks(job, voxel.owner) || was_behind(ray, i, job);
    }
    if (ends) return {i + 1, true};
  }
  return {ray.size(), false};
}

std::optional<std::size_t> LightOracle::last_thin(const Ray& ray, std::size_t i) const {
  while (i-- > 0)
    if (at_voxel(ray[i]).armour && at_voxel(ray[i]).thin) return i;
  return {};
}

bool LightOracle::was_behind(const Ray& ray, std::size_t i, const LightJob& job) const {
  const auto thin = last_thin(ray, i);
  return thin && !is_in_front(job, at_voxel(ray[*thin]).owner);
}

bool LightOracle::came_through(const Ray& ray, std::size_t i, const LightJob& job) const {
  const auto thin = last_thin(ray, i);
  if (!thin) return false;
  const Claim& owner = at_voxel(ray[*thin]).owner;
  if (!is_in_front(job, owner)) return true;
  int code = facing_[owner.facet];
  if (blocks(job, owner)) code = kOppositeFacings - code;
  const glm::ivec3 towards =
      (glm::ivec3(code / 9, code / 3 % 3, code % 3) - 1) * (ray[*thin + 1] - ray[*thin]);
  return towards.x + towards.y + towards.z < 0;
}

}  // namespace rc2::stress
