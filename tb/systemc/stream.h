// The wires of one stream as SystemC signals.
#pragma once

#include <string>
#include <systemc>

#include "tb/systemc/unit.h"

namespace rc2::tb {

constexpr int kClockNanoseconds = 10;

/// Rising edges of the clock before this one.
inline std::int64_t this_cycle() {
  return static_cast<std::int64_t>(sc_core::sc_time_stamp() /
                                   sc_core::sc_time(kClockNanoseconds, sc_core::SC_NS));
}

struct Stream {
  explicit Stream(const StreamName& named)
      : valid((named.name + "_valid").c_str()),
        ready((named.name + "_ready").c_str()),
        beat((named.name + "_beat").c_str()),
        bits(named.bits) {}

  /// Valid, ready and the limbs in use of the beat become part of the waveform.
  void trace(sc_core::sc_trace_file* file) const;

  bool moves() const { return valid.read() && ready.read(); }

  sc_core::sc_signal<bool> valid, ready;
  sc_core::sc_signal<Beat> beat;
  int bits;
};

/// What sc_signal wants of its type.
void sc_trace(sc_core::sc_trace_file* file, const Beat& beat, const std::string& name);

}  // namespace rc2::tb
