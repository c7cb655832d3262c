// What every block test needs: the Verilated module, a clock, dice.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>

#include "Vtop.h"
#include "sim/coverage.h"
#include "tb/load/dice.h"

namespace rc2::tb {

using facet::Dice;

/// Registers begin with whatever they happen to hold: only a reset makes sense of them.
struct PowerOn {
  PowerOn() { Verilated::threadContextp()->randReset(2); }
};

/// A Verilated module.
template <class Top>
struct Module : PowerOn, Top {
  ~Module() {
    this->final();
    hand_in_coverage(*this->contextp());
  }
};

/// A Verilated module with a clock and a reset.
template <class Top>
class Clocked {
 public:
  Clocked() {
    top.rst_ni = 0;
    tick();
    top.rst_ni = 1;
  }
  Clocked(const Clocked&) = delete;
  Clocked& operator=(const Clocked&) = delete;

  /// Lets the outputs follow the inputs without a clock edge.
  void settle() {
    top.clk_i = 0;
    top.eval();
  }
  void tick() {
    settle();
    top.clk_i = 1;
    top.eval();
    settle();
  }

  Module<Top> top;
};

/// Low `width` bits of a possibly negative number.
constexpr std::uint64_t bits(std::int64_t value, int width) {
  return static_cast<std::uint64_t>(value) & ((1ULL << width) - 1);
}

}  // namespace rc2::tb
