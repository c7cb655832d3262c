#include "sw/cycle/tilt.h"

#include <algorithm>
#include <cstdlib>

#include "sw/base/config.h"

namespace rc2::cycle {
namespace {

constexpr int kWholeBits = 3;
constexpr int kBitsPerCycle = 4;  // of a quotient

}  // namespace

Tilt::Tilt(int n)
    : n_(n),
      fraction_(coordinate_bits(n) + 1),
      most_((1 << (kWholeBits + fraction_)) - 1),
      // Two divisions, a cycle between them and one to take the second.
      divided_(2 * ((kWholeBits + fraction_ + kBitsPerCycle - 1) / kBitsPerCycle) + 2) {}

int Tilt::of(int rise, int distance, bool high) const {
  const bool below = high ? rise < 0 : rise <= 0, away = high != below;
  if (away && distance == 0) return below ? -most_ : most_;
  const int upper = 2 * std::abs(rise) + (away ? 1 : -1), lower = 2 * distance - (away ? 1 : -1);
  const int quotient = std::min((upper << fraction_) / lower, most_);
  const int size = away ? std::min(quotient + 1, most_) : quotient;
  return below ? -size : size;
}

int Tilt::layer(int tilt, int distance, bool high) const {
  const bool below = tilt < 0, away = high != below;
  const int size = std::abs(tilt);
  if (away && size == most_) return below ? -n_ : n_;
  const int twice = (size * std::max(2 * distance + (away ? 1 : -1), 0)) >> fraction_;
  const int layers = away ? (twice + 1) / 2 : twice / 2;
  return below ? -layers : layers;
}

}  // namespace rc2::cycle
