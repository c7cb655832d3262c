// A clocked unit at its pins, whatever it is made of: RTL through Verilator, the cycle model, or
// either with a fault. Every interface is a stream with valid and ready; AXI4-Lite is five of them.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "sw/machine/host_word.h"

namespace rc2::tb {

/// What a stream carries in one transfer, lowest bits first.
struct Beat {
  HostWord::Limbs limbs{};

  Beat() = default;
  explicit Beat(const HostWord& word) : limbs(word.limbs()) {}
  explicit Beat(std::uint64_t low) {
    limbs[0] = static_cast<std::uint32_t>(low);
    limbs[1] = static_cast<std::uint32_t>(low >> 32);
  }

  std::uint64_t low() const { return limbs[0] | static_cast<std::uint64_t>(limbs[1]) << 32; }
};

inline bool operator==(const Beat& a, const Beat& b) { return a.limbs == b.limbs; }
inline bool operator!=(const Beat& a, const Beat& b) { return !(a == b); }

/// The bits of a beat in hexadecimal, highest first.
std::ostream& operator<<(std::ostream& out, const Beat& beat);

/// A stream's wires in one cycle: `valid` and `beat` from its source, `ready` from its sink.
struct Pins {
  bool valid = false, ready = false;
  Beat beat;
};

/// Wires of all streams of a unit, in the order of its names.
struct UnitPins {
  std::vector<Pins> in, out;
};

struct StreamName {
  std::string name;
  int bits;  ///< of a beat
};

struct StreamNames {
  std::vector<StreamName> in, out;
};

class Unit {
 public:
  Unit() = default;
  virtual ~Unit() = default;
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;

  virtual const StreamNames& names() const = 0;

  /// Sets what the unit drives (`ready` of its inputs, `valid` and `beat` of its outputs) from its
  /// registers and from what the others drive.
  virtual void settle(UnitPins& pins) = 0;

  /// The rising edge of the clock, with the pins as they were last settled.
  virtual void clock(const UnitPins& pins) = 0;
};

}  // namespace rc2::tb
