// What every machine refuses, in the same words: sizes, packets and jobs out of range.
#pragma once

#include <cstdint>

#include "sw/machine/machine.h"

namespace rc2 {

/// Largest distance L: a target fits in 16 bits, and the (L+1)^2 rays that may meet in one voxel
/// fit in 32.
constexpr int kMaxDistance = (1 << 15) - 1;

/// Throws Error if no machine can have this size.
const MachineConfig& checked(const MachineConfig& config);

/// Throws Error naming the option unless `feeders` is a power of two from 1 to n.
void check_feeders(const char* option, int feeders, int n);

/// Throws Error unless the registers of the machine hold every packet, at every cell of its box.
/// What passes cannot overflow 64 bits anywhere.
void check_packets(const MachineConfig& config, const facet::PacketStream& stream);

/// Throws Error if the source is outside the cube, or L or FA is not in 1 .. the machine's maximum.
void check_light(const MachineConfig& config, const LightJob& job);

/// Throws Error if the limits are out of range, the rays do not start in the cube or are not of
/// unit length, or if a voxel's owner has no facet in the job.
void check_rays(const MachineConfig& config, const RayJob& job, const VoxelMemory& voxels);

/// Throws the Error of a source whose voxel belongs to facet `owner`.
[[noreturn]] void refuse_occupied_source(const LightJob& job, std::uint32_t owner);

}  // namespace rc2
