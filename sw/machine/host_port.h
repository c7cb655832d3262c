// The registers of the host port (rtl/rc2_machine.sv, docs/host-port.md).
#pragma once

#include <algorithm>
#include <cstdint>

#include "sw/base/config.h"

namespace rc2::host_port {

/// Byte addresses.
enum Register : std::uint8_t {
  kId = 0x00,
  kN = 0x04,
  kF = 0x08,
  kLmax = 0x0C,
  kFamax = 0x10,
  kPacketBits = 0x14,
  kReadbackBits = 0x18,
  kFacetNumberBits = 0x1C,
  kCommand = 0x20,
  kStatus = 0x24,
  kBusyCycles = 0x28,
  kHomeCycle = 0x2C,
  kHome = 0x30,
  kGapAndNormal = 0x34,
  kFeeders = 0x38,
  kLayers = 0x3C,
  kSourceX = 0x40,
  kSourceY = 0x44,
  kSourceZ = 0x48,
  kDistance = 0x4C,
  kFa = 0x50,
  kTargets = 0x54,
  kInverse = 0x58,
  kBuild = 0x5C,
  kInverseBits = 0x60,
  kSkipped = 0x64,
  kRays = 0x68,
  kRayLimits = 0x6C,
  kRule = 0x74,
};

constexpr std::uint32_t kMachineId = 0x52433202;
constexpr std::uint32_t kBuildThesis = 1;
constexpr std::uint32_t kBuildCounts = 2;
constexpr std::uint32_t kBuildSkips = 4;
constexpr std::uint32_t kCommandClear = 1;
constexpr std::uint32_t kCommandStart = 2;
constexpr std::uint32_t kCommandPrepare = 4;
constexpr std::uint32_t kCommandClearRays = 8;
constexpr std::uint32_t kCommandTrace = 16;
constexpr std::uint32_t kRuleAccurate = 1;
constexpr std::uint32_t kStatusBusy = 1;
constexpr std::uint32_t kStatusHome = 2;

/// What kBuild says of a machine.
inline std::uint32_t build_flags(const MachineConfig& config) {
  return (config.mode == LightMode::thesis ? kBuildThesis : 0) |
         (config.counts ? kBuildCounts : 0) | (config.skips ? kBuildSkips : 0);
}

/// 1/L for kInverse, rounded down to a fraction of `bits` bits; the largest fraction for L = 1.
inline std::uint32_t inverse_of(int distance, int bits) {
  const std::uint64_t one = std::uint64_t{1} << bits;
  return static_cast<std::uint32_t>(std::min(one - 1, one / static_cast<std::uint64_t>(distance)));
}

/// What kRayLimits wants.
constexpr std::uint32_t ray_limits(int depth, int queue, int least_weight) {
  return static_cast<std::uint32_t>(least_weight << 16 | queue << 8 | depth);
}

}  // namespace rc2::host_port
