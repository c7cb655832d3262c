// From the bounds of one facet at one column to the interval of z that it fills
// (rtl/load/rc2_dexel.sv): the same early decisions and the same division, one bit per cycle.
#pragma once

#include <cstdint>

#include "sw/cycle/fill.h"
#include "sw/cycle/word.h"

namespace rc2::cycle {

class Dexel {
 public:
  bool busy() const { return dividing_ || settling_; }

  /// True if a dexel is offered to the fill unit.
  bool offers() const { return settling_ && !nothing(); }
  Span offered() const { return {facet_, z0_ + lo_, z0_ + hi_}; }

  /// True if the unit can take a word while the fill unit is, or is not, ready.
  bool ready(bool fill_ready) const {
    return !dividing_ && (!settling_ || nothing() || fill_ready);
  }

  /// One cycle. `word` is a word that the unit takes, or null.
  void step(const Word* word, bool fill_ready);

 private:
  bool nothing() const { return empty_ || lo_ > hi_; }
  void take_head(const Word& word);
  void take_bound(const Word& word);
  void divide();

  // The packet's box: z counts from z0_; top_ is 2^bits(range), surely above the range.
  std::uint32_t facet_ = 0;
  std::int32_t z0_ = 0, lo_ = 0, hi_ = 0, top_ = 1;
  bool empty_ = true;
  bool settling_ = false;  // the last bound is settled: the dexel, if any, is offered

  bool dividing_ = false, lower_ = false, last_ = false;
  std::int64_t rest_ = 0, divisor_ = 0;
  std::int32_t bit_ = 0, quotient_ = 0;
};

}  // namespace rc2::cycle
