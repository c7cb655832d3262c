// The registers of the host port (rtl/rc2_machine.sv, docs/host-port.md).
#pragma once

#include <cstdint>

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
  kFeeders = 0x38,
  kLayers = 0x3C,
  kSourceX = 0x40,
  kSourceY = 0x44,
  kSourceZ = 0x48,
  kDistance = 0x4C,
  kFa = 0x50,
  kTargets = 0x54,
};

constexpr std::uint32_t kMachineId = 0x52433201;
constexpr std::uint32_t kCommandClear = 1;
constexpr std::uint32_t kCommandStart = 2;
constexpr std::uint32_t kStatusBusy = 1;
constexpr std::uint32_t kStatusHome = 2;

}  // namespace rc2::host_port
