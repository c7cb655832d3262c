// From the slab and the sides of one facet at one column to the interval of z that it fills and the
// part of it that is its core (rtl/load/rc2_dexel.sv): the same early decisions and the same
// divisions, one bit per cycle.
#pragma once

#include <array>
#include <cstdint>

#include "sw/cycle/fill.h"
#include "sw/machine/word.h"

namespace rc2::cycle {

class Dexel {
 public:
  /// Whether the unit is through with a word that waits for it at the end of this cycle, if the
  /// fill unit is, or is not, ready.
  bool ready(const Word& word, bool fill_ready) const;

  /// One cycle with the word that waits, which leaves at its end if `taken`.
  void step(const Word& word, bool taken);

  /// Whether the packet that ends with this GAP fills anything, and what.
  bool offers(const Word& word) const { return word.kind == WordKind::gap && !outer_.empty(); }
  Span offered(const Word& gap) const;

  bool dividing() const { return dividing_; }

 private:
  struct Interval {
    std::int32_t lo, hi;
    bool empty() const { return lo > hi; }
  };

  // One of a word's two bounds on z: z >= quotient (lower) or z <= quotient, the quotient rounded
  // down; a flat one says yes or no to all z.
  struct Bound {
    bool flat, lower;
    std::int64_t numerator, divisor;
    bool core;  ///< narrows core_, not outer_
    bool none;  ///< there is no such bound
  };

  // The division of one bound.
  struct Quotient {
    bool wanted = false;
    std::int64_t rest = 0;
    std::int32_t value = 0;
  };

  std::array<Bound, 2> bounds(const Word& word) const;
  bool is_beyond(const Bound& bound) const { return bound.numerator >= bound.divisor * top_; }
  bool fails(const Bound& bound) const;
  bool divides(const Bound& bound) const;
  bool divides(const Word& word) const;
  Interval& interval(const Bound& bound) { return bound.core ? core_ : outer_; }
  void take_head(const Word& word);
  void begin(const Word& word);
  void divide(const Word& word);

  // The packet's box: z counts from z0_; top_ is 2^bits(range), surely above the range.
  std::uint32_t facet_ = 0;
  facet::Layer layer_ = facet::Layer::armour;
  std::int64_t width_ = 0;
  std::int32_t z0_ = 0, top_ = 1;
  Interval outer_{0, 0}, core_{0, 0};

  bool dividing_ = false;
  std::array<Quotient, 2> quotients_;
  std::int64_t divisor_ = 0;
  std::int32_t bit_ = 0;
};

}  // namespace rc2::cycle
