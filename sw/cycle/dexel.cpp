#include "sw/cycle/dexel.h"

#include <algorithm>
#include <cstdlib>

#include "sw/machine/plane.h"

namespace rc2::cycle {

bool Dexel::ready(const Word& word, bool fill_ready) const {
  if (word.kind == WordKind::head || outer_.empty()) return true;
  if (word.kind == WordKind::gap) return fill_ready;
  return dividing_ ? bit_ == 1 : !divides(word);
}

void Dexel::step(const Word& word, bool taken) {
  if (word.kind == WordKind::head) {
    if (taken) take_head(word);
  } else if (word.kind != WordKind::gap && !outer_.empty() && (taken || !ready(word, false))) {
    if (dividing_) {
      divide(word);
    } else {
      begin(word);
    }
  }
}

Span Dexel::offered(const Word& gap) const {
  const glm::ivec3 normal(normal_part(gap.step[0]), normal_part(gap.step[1]), normal_part(gap.c));
  return {facet_,    layer_,   gap.surface, normal, z0_,  outer_.lo,
          outer_.hi, core_.lo, core_.hi,    gap.d,  gap.c};
}

void Dexel::take_head(const Word& word) {
  facet_ = word.facet;
  layer_ = word.layer;
  width_ = word.reach;
  z0_ = word.z0;
  outer_ = core_ = {0, word.z_span};
  for (top_ = 1; top_ <= word.z_span; top_ *= 2) {
  }
}

// c*z + e >= 0 is z >= floor((c-1-e)/c) for c > 0 and z <= floor(e/-c) for c < 0. A slab has a back
// c*z + d >= 0 and a front -c*z + width - d >= 0, a side has c*z + d >= 0 and a core
// c*z + d - push >= 0. A packet of the layer "inside" has no front.
std::array<Dexel::Bound, 2> Dexel::bounds(const Word& word) const {
  const bool slab = word.kind == WordKind::slab;
  const auto bound = [](std::int64_t c, std::int64_t e, bool core, bool none = false) {
    const bool lower = c > 0;
    const std::int64_t divisor = std::abs(c);
    return Bound{c == 0, lower, lower ? divisor - 1 - e : e, divisor, core, none};
  };
  return {bound(word.c, word.d, false),
          slab ? bound(-word.c, width_ - word.d, false, layer_ == facet::Layer::inside)
               : bound(word.c, word.d - word.reach, true)};
}

bool Dexel::divides(const Bound& bound) const {
  return !bound.none && !bound.flat && bound.numerator >= 0 && !is_beyond(bound) && top_ != 1 &&
         !(bound.core ? core_ : outer_).empty();
}

// Holds for no z of the range.
bool Dexel::fails(const Bound& bound) const {
  if (bound.none) return false;
  return bound.flat || !bound.lower ? bound.numerator < 0 : is_beyond(bound);
}

// Nothing is divided for a dexel that the other bound has emptied.
bool Dexel::divides(const Word& word) const {
  const auto both = bounds(word);
  for (const Bound& bound : both) {
    if (!bound.core && fails(bound)) return false;
  }
  return divides(both[0]) || divides(both[1]);
}

void Dexel::begin(const Word& word) {
  const auto both = bounds(word);
  dividing_ = divides(word);
  bit_ = top_ / 2;
  divisor_ = both[0].divisor * bit_;
  for (std::size_t i = 0; i < 2; ++i) quotients_[i] = {divides(both[i]), both[i].numerator, 0};
  for (const Bound& bound : both) {
    if (fails(bound)) interval(bound) = {1, 0};
  }
}

void Dexel::divide(const Word& word) {
  const auto both = bounds(word);
  for (std::size_t i = 0; i < 2; ++i) {
    Quotient& quotient = quotients_[i];
    if (quotient.rest >= divisor_) {
      quotient.rest -= divisor_;
      quotient.value |= bit_;
    }
    if (bit_ != 1 || !quotient.wanted) continue;
    Interval& narrowed = interval(both[i]);
    if (both[i].lower) {
      narrowed.lo = std::max(narrowed.lo, quotient.value);
    } else {
      narrowed.hi = std::min(narrowed.hi, quotient.value);
    }
  }
  dividing_ = bit_ != 1;
  divisor_ /= 2;
  bit_ /= 2;
}

}  // namespace rc2::cycle
