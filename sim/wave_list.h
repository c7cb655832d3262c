// The list of signals that GTKWave opens beside a waveform: the host port, the light, and the
// cells around the source, at the moment in which the light starts.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "sw/base/config.h"

namespace rc2 {

constexpr std::int64_t kWaveTimePerCycle = 10;

/// Where cell (x,y) is in the Verilated machine's hierarchy.
std::string cell_scope(const MachineConfig& config, int x, int y);

/// Writes the save file beside the waveform (waves.fst -> waves.gtkw), for a machine whose light of
/// this source started in cycle `start`, with the cells around the source or around `cell`. Throws
/// Error if it cannot be written.
void write_wave_list(const std::string& waves, const MachineConfig& config, glm::ivec3 source,
                     std::int64_t start, std::optional<glm::ivec2> cell);

}  // namespace rc2
