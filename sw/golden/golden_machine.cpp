#include "sw/golden/golden_machine.h"

#include "sw/golden/diffuse.h"
#include "sw/golden/trace.h"
#include "sw/golden/voxelise.h"
#include "sw/machine/checks.h"

namespace rc2::golden {

GoldenMachine::GoldenMachine(const MachineConfig& config)
    : config_(checked(config)), grid_(config.n), layers_(config.n) {}

LoadResult GoldenMachine::load(const facet::PacketStream& packets, const Progress& progress) {
  check_packets(config_, packets);

  if (grid_holds_ != Holds::nothing) grid_.clear();
  grid_holds_ = Holds::claims;
  layers_.clear();
  voxels_.clear();
  arrived_.clear();
  std::size_t packet = 0;
  for (const facet::Batch& batch : packets.batches) {
    for (; packet < batch.first + batch.count; ++packet) add_packet(packets, packet);
    if (batch.ends_object) layers_.end_object();
  }
  for (; packet < packets.heads.size(); ++packet) {
    add_packet(packets, packet);
    if (progress && packet % 4096 == 0) {
      progress("load", 0, static_cast<double>(packet) / static_cast<double>(packets.heads.size()));
    }
  }
  return {};
}

void GoldenMachine::add_packet(const facet::PacketStream& packets, std::size_t packet) {
  const facet::PacketHead& head = packets.heads[packet];
  const facet::Side* sides = packets.sides.data() + head.first_side;
  if (head.layer == facet::Layer::armour) {
    fill_facet(grid_, head, sides);
  } else {
    layers_.add(grid_, head, sides);
  }
  // A facet's packets say the same of its plane; those of the layer inside may be of none.
  if (head.layer == facet::Layer::armour || head.layer == facet::Layer::guard)
    layers_.note_plane(head);
}

void GoldenMachine::number_voxels() {
  if (grid_holds_ != Holds::claims) return;
  grid_holds_ = Holds::numbers;
  for (glm::ivec3 at{0}; at.z < config_.n; ++at.z) {
    for (at.y = 0; at.y < config_.n; ++at.y) {
      std::uint32_t* const row = &grid_[grid_.index({0, at.y, at.z})];
      for (at.x = 0; at.x < config_.n; ++at.x) {
        std::uint32_t& voxel = row[at.x];
        if (voxel == Grid::kFree) continue;
        voxels_.push_back({at, Claim::unpacked(voxel)});
        voxel = static_cast<std::uint32_t>(voxels_.size() - 1);
      }
    }
  }
}

LightResult GoldenMachine::light(const LightJob& job, const Progress& progress) {
  check_light(config_, job);
  number_voxels();
  const std::uint32_t source_voxel = grid_[grid_.index(job.source)];
  if (source_voxel != Grid::kFree) refuse_occupied_source(job, voxels_[source_voxel].owner.facet);

  arrived_.assign(voxels_.size(), 0);
  const std::vector<Matter> field = look_from(job, grid_, voxels_, layers_);
  const Diffusion diffusion =
      diffuse(grid_, field, job.source, job.target_distance, arrived_, progress);
  LightResult result;
  result.visits = diffusion.visits;
  result.targets = diffusion.targets;
  return result;
}

RayResult GoldenMachine::trace(const RayJob& job, const Progress& progress) {
  number_voxels();
  check_rays(config_, job, voxels_);
  return golden::trace(grid_, voxels_, layers_, job, progress);
}

VoxelMemory GoldenMachine::read_voxels() {
  number_voxels();
  return voxels_;
}

LightMemory GoldenMachine::read_light() {
  number_voxels();
  arrived_.resize(voxels_.size());
  return arrived_;
}

}  // namespace rc2::golden
