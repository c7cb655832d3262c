// The whole machine at its host port (docs/host-port.md), as RTL and as cycle model.
#pragma once

#include <memory>
#include <string>

#include "sw/base/config.h"
#include "sw/machine/host_word.h"
#include "tb/systemc/unit.h"

namespace rc2::tb {

/// Of the side that CMake gives the RTL too; with more than one packet stream.
constexpr MachineConfig kMachine{RC2_N, 4, 4 * RC2_N, 32, 2, true};

/// Numbers of the streams. Packet stream k is input kPackets + k.
enum MachineIn : std::size_t { kAw, kW, kAr, kPackets };
enum MachineOut : std::size_t { kB, kR, kReadback };

/// AXI4-Lite's five channels: addresses, data of a write, {response, data} of a read, response of
/// a write; the packet streams; the readback with `tlast` in bit 63.
StreamNames machine_streams();

constexpr int kReadLastBit = 63;
constexpr int kReadResponseBit = 32;

/// `waves`: an FST file for the signals inside, or empty.
std::unique_ptr<Unit> make_rtl_machine(const std::string& waves);
std::unique_ptr<Unit> make_cycle_machine();

}  // namespace rc2::tb
