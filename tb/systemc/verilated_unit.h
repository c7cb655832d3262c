// What every Verilated unit has: a clock, a reset, pins that take beats, a waveform of its inside.
#pragma once

#include <verilated.h>
#include <verilated_fst_c.h>

#include <cstring>
#include <string>

#include "sim/coverage.h"
#include "tb/systemc/unit.h"

namespace rc2::tb {

/// Puts the low bytes of a beat into a pin, `bytes` of them from byte `at`; 0: as many as it has.
template <typename Pin>
void put(Pin& pin, const Beat& beat, std::size_t at = 0, std::size_t bytes = 0) {
  std::memcpy(reinterpret_cast<unsigned char*>(&pin) + at, beat.limbs.data(),
              bytes == 0 ? sizeof pin : bytes);
}

template <typename Pin>
Beat get(const Pin& pin) {
  static_assert(sizeof pin <= sizeof(Beat));
  Beat beat;
  std::memcpy(beat.limbs.data(), &pin, sizeof pin);
  return beat;
}

template <class Top>
class VerilatedUnit : public Unit {
 public:
  /// Resets the unit. Ten units of time in the waveform are a cycle; no path: no waveform.
  explicit VerilatedUnit(const std::string& waves) {
    if (!waves.empty()) {
      context_.traceEverOn(true);
      top_.trace(&trace_, 99);
    }
    top_.rst_ni = 0;
    low();
    high();
    low();
    top_.rst_ni = 1;
    if (!waves.empty()) trace_.open(waves.c_str());
  }
  ~VerilatedUnit() override {
    trace_.close();
    top_.final();
    hand_in_coverage(context_);
  }

  void settle(UnitPins& pins) final {
    drive(top_, pins);
    top_.eval();
    observe(top_, pins);
  }

  void clock(const UnitPins& pins) final {
    before_edge(top_, pins);
    low();
    if (cycle_ > 0) dump(10 * cycle_ - 5);
    high();
    dump(10 * cycle_);
    ++cycle_;
  }

 protected:
  /// Sets the inputs of the module.
  virtual void drive(Top& top, const UnitPins& pins) = 0;
  /// Reads its outputs.
  virtual void observe(const Top& top, UnitPins& pins) = 0;
  /// Does by the pins what the unit's surroundings do at the edge.
  virtual void before_edge(const Top& /*top*/, const UnitPins& /*pins*/) {}

 private:
  void low() {
    top_.clk_i = 0;
    top_.eval();
  }
  void high() {
    top_.clk_i = 1;
    top_.eval();
  }
  void dump(std::int64_t time) {
    if (trace_.isOpen()) trace_.dump(static_cast<std::uint64_t>(time));
  }

  VerilatedContext context_;
  Top top_{&context_, "rtl"};
  VerilatedFstC trace_;
  std::int64_t cycle_ = 0;
};

}  // namespace rc2::tb
