// Who owns a voxel that several facets fill.
//
// First a facet whose border, before it was pushed out, holds the voxel centre (its core); then the
// one whose plane is nearest to the centre; then the lowest number. By distance alone coplanar
// neighbours would tie, and the lower number would take the fringe that the push added to the
// other.
#pragma once

#include <cstdint>

#include "sw/base/config.h"

namespace rc2 {

/// What a facet says of a voxel it fills, and what the machine keeps of the owner.
struct Claim {
  std::uint32_t facet = 0;
  bool core = false;
  /// Signed distance from the plane to the voxel centre along the plane's dominant axis, r / K,
  /// rounded down to sixteenths of a voxel: -64 .. 63. Positive in front of the facet.
  int gap = 0;

  /// The better claim has the lower number: {not core, distance, facet, behind}. Distances count
  /// alike on both sides of the plane: -1 (0 to 1/16 behind) is as near as 0 (0 to 1/16 in front).
  std::uint32_t packed() const {
    const bool behind = gap < 0;
    const auto distance = static_cast<std::uint32_t>(behind ? ~gap : gap);
    return (((core ? 0U : 1U) << (kGapBits - 1) | distance) << kFacetBits | facet) << 1 |
           (behind ? 1U : 0U);
  }

  static Claim unpacked(std::uint32_t bits) {
    const auto distance = static_cast<int>(bits >> (1 + kFacetBits) & ((1U << (kGapBits - 1)) - 1));
    return {bits >> 1 & (kMaxFacets - 1), (bits >> (kFacetBits + kGapBits)) == 0,
            (bits & 1U) != 0 ? ~distance : distance};
  }
};

inline bool operator==(const Claim& a, const Claim& b) { return a.packed() == b.packed(); }

/// The gap that a fixed-point value stands for: all its fraction bits but the first four fall away,
/// and so does what a distance of less than four voxels has no need of.
inline int gap_of(int n, std::int64_t value) {
  constexpr int kSign = 1 << (kGapBits - 1);
  const auto bits = static_cast<std::uint64_t>(value) >> (gap_fraction_bits(n) - kGapFractionBits);
  return (static_cast<int>(bits & (2 * kSign - 1)) ^ kSign) - kSign;
}

}  // namespace rc2
