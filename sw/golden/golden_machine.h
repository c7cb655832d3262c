// The machine without time or cells: one facet after another, one ray after another.
//
// Every other machine is compared with this one, so it shares nothing with them but types.
#pragma once

#include "sw/golden/grid.h"
#include "sw/golden/layers.h"
#include "sw/machine/machine.h"

namespace rc2::golden {

class GoldenMachine : public Machine {
 public:
  /// An empty machine; takes 4(n+2)^3 bytes. Throws Error if the configuration is out of range.
  explicit GoldenMachine(const MachineConfig& config);

  const MachineConfig& config() const override { return config_; }

  /// The machine is left as it was if a packet is out of range.
  LoadResult load(const facet::PacketStream& packets, const Progress& progress) override;

  /// Throws Error if the source is not a free voxel of the cube, or if L or FA is not in
  /// 1 .. the machine's maximum.
  LightResult light(const LightJob& job, const Progress& progress) override;

  RayResult trace(const RayJob& job, const Progress& progress) override;

  VoxelMemory read_voxels() override;
  LayerMemory read_layers() override { return layers_.read(grid_); }
  LightMemory read_light() override;

 private:
  void add_packet(const facet::PacketStream& packets, std::size_t packet);

  // What occupied voxels of the grid hold: the owner's claim, or the voxel's number in voxels_.
  enum class Holds { nothing, claims, numbers };

  // Unless that is done, lists the occupied voxels in the order of every dump and puts into the
  // grid, in place of the owner's claim, the number of the voxel: where to count the rays that end
  // there. Looks at the whole cube, which would take as long as to load a small scene.
  void number_voxels();

  MachineConfig config_;
  Grid grid_;
  Holds grid_holds_ = Holds::nothing;
  Layers layers_;
  VoxelMemory voxels_;
  LightMemory arrived_;
};

}  // namespace rc2::golden
