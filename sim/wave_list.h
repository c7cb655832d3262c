// The list of signals that GTKWave opens beside a waveform: the host port, the light, and the
// cells around the source, at the moment in which the light starts.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "sw/base/config.h"

namespace rc2 {

constexpr std::int64_t kWaveTimePerCycle = 10;

/// Writes the save file beside the waveform (waves.fst -> waves.gtkw), for a machine whose light of
/// this source started in cycle `start`. Throws Error if it cannot be written.
void write_wave_list(const std::string& waves, const MachineConfig& config, glm::ivec3 source,
                     std::int64_t start);

}  // namespace rc2
