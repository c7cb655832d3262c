#include "sw/cycle/dexel.h"

#include <algorithm>

namespace rc2::cycle {

void Dexel::step(const Word* word, bool fill_ready) {
  if (settling_ && (nothing() || fill_ready)) settling_ = false;
  if (dividing_) {
    divide();
  } else if (word != nullptr) {
    if (word->kind == Kind::head) {
      take_head(*word);
    } else {
      take_bound(*word);
    }
  }
}

void Dexel::take_head(const Word& word) {
  facet_ = word.facet;
  z0_ = word.z0;
  lo_ = 0;
  hi_ = word.z_span;
  for (top_ = 1; top_ <= hi_; top_ *= 2) {
  }
  empty_ = false;
}

// The bound c*z + d >= 0 is z >= floor((c-1-d)/c) for c > 0 and z <= floor(d/-c) for c < 0.
void Dexel::take_bound(const Word& word) {
  if (word.c == 0) {
    empty_ = empty_ || word.d < 0;
    settling_ = word.last;
    return;
  }
  lower_ = word.c > 0;
  const std::int64_t divisor = lower_ ? word.c : -word.c;
  const std::int64_t numerator = lower_ ? word.c - 1 - word.d : word.d;
  const bool below = numerator < 0;
  const bool above = numerator >= divisor * top_;
  if (!below && !above && top_ != 1 && !empty_) {
    dividing_ = true;
    last_ = word.last;
    rest_ = numerator;
    bit_ = top_ / 2;
    divisor_ = divisor * bit_;
    quotient_ = 0;
  } else {
    empty_ = empty_ || (lower_ ? above : below);
    settling_ = word.last;
  }
}

void Dexel::divide() {
  if (rest_ >= divisor_) {
    rest_ -= divisor_;
    quotient_ |= bit_;
  }
  divisor_ /= 2;
  if (bit_ == 1) {
    if (lower_) {
      lo_ = std::max(lo_, quotient_);
    } else {
      hi_ = std::min(hi_, quotient_);
    }
    dividing_ = false;
    settling_ = last_;
  }
  bit_ /= 2;
}

}  // namespace rc2::cycle
