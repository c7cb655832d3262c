// The host port of any Machine as software meets it: registers, a queue of packet words, a queue of
// readback. Knows of clock cycles, not of SystemC.
#pragma once

#include <cstdint>
#include <deque>

#include "sw/machine/host_word.h"
#include "sw/machine/machine.h"
#include "sw/tlm/packet_reader.h"

namespace rc2::tlm {

class HostPort {
 public:
  /// Throws Error if the machine's counts do not fit the registers. `machine` must outlive this.
  explicit HostPort(Machine& machine);

  /// Whether there is a register at this address, and whether it can be written.
  static bool is_register(std::uint64_t address);
  static bool is_writable(std::uint64_t address);

  /// To read whether the machine is at rest, or what it took, has it load what was sent; throws
  /// Error if it refuses that.
  std::uint32_t read(std::uint64_t address);

  /// Throws Error if the machine refuses the command.
  void write(std::uint64_t address, std::uint32_t value);

  /// A packet word, END or READ. Throws Error if it cannot come here or the machine refuses it.
  void push(const HostWord::Limbs& limbs);

  std::size_t waiting() const { return readback_.size(); }
  /// The next beat of readback; only if one is waiting.
  std::uint64_t pop();

  /// Cycles that the machine has worked since this was asked last.
  std::int64_t take_cycles();

 private:
  // Loads what has been sent since the last command, if anything.
  void settle();
  void start();
  void answer(ReadWhat what);
  LightJob job() const;

  Machine& machine_;
  WordFormat format_;
  PacketReader reader_;
  bool loaded_ = false;
  std::uint32_t source_x_ = 0, source_y_ = 0, source_z_ = 0, distance_ = 0, fa_ = 0, targets_ = 0,
                inverse_ = 0, rule_ = 0;
  LightResult light_;
  std::int64_t busy_cycles_ = 0, cycles_ = 0;
  std::deque<std::uint64_t> readback_;
};

}  // namespace rc2::tlm
