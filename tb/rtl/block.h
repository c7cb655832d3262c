// What every block test needs: the Verilated module, a clock, dice.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>

#include "Vtop.h"
#include "tb/load/dice.h"

namespace rc2::tb {

using facet::Dice;

/// A Verilated module with a clock and a reset.
template <class Top>
class Clocked {
 public:
  Clocked() {
    top.rst_ni = 0;
    tick();
    top.rst_ni = 1;
  }
  ~Clocked() { top.final(); }
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

  Top top;
};

/// Low `width` bits of a possibly negative number.
constexpr std::uint64_t bits(std::int64_t value, int width) {
  return static_cast<std::uint64_t>(value) & ((1ULL << width) - 1);
}

}  // namespace rc2::tb
