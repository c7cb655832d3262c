// The outline of a facet, followed from its highest line down on both sides at once: what the
// thesis's first two discretisers (3.2, 3.3) have in common.
//
// Both go from line to line (Y = const, one voxel apart) and begin a new side where Y equals that
// of a corner; corners between lines are never met. So the corners are voxels here: borders in
// whole voxels, as the chapter's integer coefficients suggest too.
#pragma once

#include <cstdint>

#include "sw/facet/polygon.h"

namespace rc2::surface {

struct Fraction {
  std::int64_t numerator, denominator;  ///< denominator > 0
};

/// The thesis's "proche", the nearest integer; it does not say which when two are. Upwards here.
inline std::int64_t nearest(const Fraction& value) {
  const std::int64_t twice = 2 * value.denominator;
  const std::int64_t sum = 2 * value.numerator + value.denominator;
  return sum / twice - (sum % twice < 0 ? 1 : 0);
}

/// Where a side of the outline meets a line.
struct Crossing {
  Fraction x, z;
};

/// One of the two chains of sides from the highest line to the lowest.
class Outline {
 public:
  /// `turn` is +1 to follow the border's order (the thesis's s1, succ), -1 to go against it (s2,
  /// pred). The border is planar and convex, in whole voxels, and not all of one height.
  Outline(const facet::Border& border, int turn);

  std::int64_t top() const { return border_[from_].y; }

  /// Lines are asked for from top() downwards, none after the lowest corner.
  Crossing at(std::int64_t y);

 private:
  std::size_t next(std::size_t corner) const {
    return (corner + border_.size() + turn_) % border_.size();
  }

  const facet::Border& border_;
  std::size_t turn_;
  std::size_t from_, to_;  ///< ends of the side in use, the upper one first
};

}  // namespace rc2::surface
