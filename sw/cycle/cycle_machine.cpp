#include "sw/cycle/cycle_machine.h"

#include "sw/cycle/cell.h"
#include "sw/cycle/ray_array.h"
#include "sw/machine/checks.h"

namespace rc2::cycle {

CycleMachine::CycleMachine(const MachineConfig& config)
    : config_(checked(config)),
      columns_(config.n),
      light_array_(config.n, columns_),
      lane_array_(config.n, config.skips, columns_) {}

LoadResult CycleMachine::load(const facet::PacketStream& packets, const Progress& progress) {
  check_packets(config_, packets);
  columns_.clear();
  const LoadResult result{
      LoadArray(config_.n, config_.feeders, columns_).run(packets, load_observer_, progress)};
  if (config_.mode == LightMode::fast) lane_array_.settle();
  boxes_ = boxes_of(packets);
  return result;
}

LightResult CycleMachine::light(const LightJob& job, const Progress& progress) {
  check_light(config_, job);
  const std::size_t column = cell_number(job.source.x, job.source.y, config_.n);
  if (columns_.occupied(column, job.source.z)) {
    refuse_occupied_source(job, columns_.owner(column, job.source.z).claim.facet);
  }
  return config_.mode == LightMode::thesis ? light_array_.run(job, observer_, progress)
                                           : lane_array_.run(job, observer_, progress);
}

RayResult CycleMachine::trace(const RayJob& job, const Progress& progress) {
  check_rays(config_, job, read_voxels());
  std::vector<std::vector<Word>> words;
  words.reserve(static_cast<std::size_t>(config_.feeders));
  for (int k = 0; k < config_.feeders; ++k)
    words.push_back(ray_word_sorts(config_, boxes_, job, k));
  const std::int64_t load_cycles =
      LoadArray(config_.n, config_.feeders, columns_).run(words, progress);
  RayResult result = RayArray(config_.n, columns_, config_.ray_units, job).run(progress);
  result.traffic.load_cycles = load_cycles;
  return result;
}

template <typename Visit>
void CycleMachine::for_each_voxel(Visit visit) const {
  for (glm::ivec3 at{0}; at.z < config_.n; ++at.z) {
    std::size_t column = 0;
    for (at.y = 0; at.y < config_.n; ++at.y) {
      for (at.x = 0; at.x < config_.n; ++at.x, ++column) {
        visit(at, column);
      }
    }
  }
}

template <typename Visit>
void CycleMachine::for_each_occupied(Visit visit) const {
  for_each_voxel([&](glm::ivec3 at, std::size_t column) {
    if (columns_.occupied(column, at.z)) visit(at, column);
  });
}

LayerMemory CycleMachine::read_layers() {
  LayerMemory memory;
  const Columns& columns = columns_;
  for_each_voxel([&](glm::ivec3 at, std::size_t column) {
    const ColumnLayers& layers = columns.layers(column);
    const LayerRecord record{at, columns.occupied(column, at.z), layers.shown.has(at.z),
                             layers.inside.has(at.z), columns.is_guard(column, at.z)};
    if (record.armour || record.shown || record.inside || record.guard) memory.push_back(record);
  });
  return memory;
}

VoxelMemory CycleMachine::read_voxels() {
  VoxelMemory voxels;
  for_each_occupied([&](glm::ivec3 at, std::size_t column) {
    voxels.push_back({at, columns_.owner(column, at.z).claim});
  });
  return voxels;
}

LightMemory CycleMachine::read_light() {
  LightMemory light;
  for_each_occupied(
      [&](glm::ivec3 at, std::size_t column) { light.push_back(columns_.arrived(column, at.z)); });
  return light;
}

}  // namespace rc2::cycle
