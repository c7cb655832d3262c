// The machine cycle by cycle: the same registers as rtl/, unit for unit and name for name, without
// the readback. Cells at rest cost nothing.
#pragma once

#include "sw/cycle/lane_array.h"
#include "sw/cycle/light_array.h"
#include "sw/cycle/load_array.h"
#include "sw/machine/machine.h"
#include "sw/machine/ray_words.h"

namespace rc2::cycle {

class CycleMachine : public Machine {
 public:
  /// An empty machine. Throws Error if the configuration is out of range.
  explicit CycleMachine(const MachineConfig& config);
  CycleMachine(const CycleMachine&) = delete;
  CycleMachine& operator=(const CycleMachine&) = delete;

  const MachineConfig& config() const override { return config_; }

  /// The machine is left as it was if a packet is out of range.
  LoadResult load(const facet::PacketStream& packets, const Progress& progress) override;

  /// Throws Error if the source is not a free voxel of the cube, or if L or FA is not in
  /// 1 .. the machine's maximum. Throws std::logic_error if the machine loses a target or blocks.
  LightResult light(const LightJob& job, const Progress& progress) override;

  /// Throws std::logic_error if the array blocks or loses a ray.
  RayResult trace(const RayJob& job, const Progress& progress) override;

  VoxelMemory read_voxels() override;
  LayerMemory read_layers() override;
  LightMemory read_light() override;

  void observe(const QueueObserver& observer) override { observer_ = observer; }

  /// Calls `observer` in every cycle of every load.
  void observe_load(LoadObserver observer) { load_observer_ = std::move(observer); }

 private:
  // visit(voxel, column) of every voxel of the cube, in the order of every dump.
  template <typename Visit>
  void for_each_voxel(Visit visit) const;
  template <typename Visit>
  void for_each_occupied(Visit visit) const;

  MachineConfig config_;
  Columns columns_;
  std::vector<FacetBox> boxes_;  // of what is loaded
  LightArray light_array_;
  LaneArray lane_array_;
  QueueObserver observer_;
  LoadObserver load_observer_;
};

}  // namespace rc2::cycle
