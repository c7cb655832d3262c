#include "sw/machine/readback.h"

namespace rc2 {

Readback::Readback(const MachineConfig& config)
    : n_(config.n),
      format_(config),
      cells_(static_cast<std::size_t>(config.n) * static_cast<std::size_t>(config.n)) {}

void Readback::add(glm::ivec3 at, std::uint32_t value) {
  const int cell = at.y * n_ + at.x;
  cells_[static_cast<std::size_t>(cell)].push_back({at.z, value});
}

std::vector<std::vector<std::uint64_t>> Readback::beats() const {
  std::vector<std::vector<std::uint64_t>> all;
  for (const auto& cell : cells_) {
    auto& beats = all.emplace_back();
    for (const Said& said : cell) {
      const bool last = beats.size() + 1 == cell.size();
      beats.push_back(pack_readback(format_, {last, false, said.z, said.value}));
    }
    if (cell.empty()) beats.push_back(pack_readback(format_, {true, true, 0, 0}));
  }
  return all;
}

Readback readback_of(const MachineConfig& config, const VoxelMemory& voxels) {
  Readback readback(config);
  for (const VoxelRecord& voxel : voxels) readback.add(voxel.at, voxel.owner.packed());
  return readback;
}

Readback readback_of(const MachineConfig& config, const LayerMemory& layers) {
  Readback readback(config);
  for (const LayerRecord& voxel : layers) readback.add(voxel.at, packed_layers(voxel));
  return readback;
}

Readback readback_of(const MachineConfig& config, const VoxelMemory& voxels,
                     const LightMemory& light) {
  Readback readback(config);
  for (std::size_t i = 0; i < voxels.size(); ++i) readback.add(voxels[i].at, light[i]);
  return readback;
}

}  // namespace rc2
