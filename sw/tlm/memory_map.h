// Where software finds what in the target's address space (docs/tlm.md).
#pragma once

#include <cstdint>

namespace rc2::tlm {

/// The registers of sw/machine/host_port.h and, after them, these; 32 bits each.
enum ModelRegister : std::uint8_t {
  kWaiting = 0x80,       ///< beats of readback that wait
  kVisitsLow = 0x84,     ///< beams served by the last light
  kVisitsHigh = 0x88,    ///< their upper 32 bits
  kDeepestQueue = 0x8C,  ///< of the last light
  kAbsorbed = 0x90,      ///< its targets that ended in voxels
  kPrepareCycles = 0x94  ///< cycles that it took to prepare
};
constexpr std::uint64_t kRegisters = 0x0000, kRegistersSize = 0x100;

/// Words of packets are written here, lowest bits first, one to a place; the window is a queue: an
/// address only has to be that of a place.
constexpr std::uint64_t kPackets = 0x1000, kPacketsSize = 0x1000;
constexpr unsigned kPacketBytes = 32;

/// Beats of readback are read here, likewise; the top bit marks the beat that ends the readback.
constexpr std::uint64_t kReadback = 0x2000, kReadbackSize = 0x1000;
constexpr unsigned kReadbackBytes = 8;
constexpr std::uint64_t kReadbackEnd = std::uint64_t{1} << 63;

constexpr std::uint64_t kSize = 0x3000;

}  // namespace rc2::tlm
