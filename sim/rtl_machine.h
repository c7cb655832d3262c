// The third Machine: the Verilated array. One shared library per n, because n is part of the
// hardware; the program loads the one that a run asks for.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

#include "sw/machine/machine.h"

namespace rc2 {

/// A waveform of the cycles from .. from+cycles-1, counted from reset. No path: no waveform.
struct WaveWindow {
  std::string path;
  std::int64_t from = 0;
  std::int64_t cycles = 0;
  std::optional<glm::ivec2> cell{};  ///< to be listed beside it instead of the light's own
};

/// Loads build/rtl/librc2_rtl_<NAME>.so (beside the program) and resets the machine in it; the name
/// is n<N> for light in lanes, thesis_n<N> for thesis mode. Throws Error if there is none, saying
/// how to build it.
std::unique_ptr<Machine> make_rtl_machine(const std::string& name, const WaveWindow& waves);

/// What such a library exports under the name kRtlFactory.
using RtlFactory = Machine*(const WaveWindow& waves);
constexpr const char* kRtlFactory = "rc2_make_verilated_machine";

}  // namespace rc2
