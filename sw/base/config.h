// The size of a machine, and every integer width that follows from it.
//
// rtl/rc2_pkg.sv derives the same widths for the hardware; the hardware reports its own through
// its capability registers and the host refuses to talk to a machine whose numbers differ.
#pragma once

#include <algorithm>
#include <string>

namespace rc2 {

/// Row feeders of a machine that nobody asked for other.
constexpr int default_feeders(int n) {
  return n >= 64 ? 16 : n >= 32 ? 8 : n >= 16 ? 4 : n >= 8 ? 2 : 1;
}

/// How light spreads through a machine.
enum class LightMode {
  fast,   ///< in lanes: whole columns at once, a step every two cycles
  thesis  ///< voxel by voxel through one queue a cell (thesis 4.4)
};

/// "fast" or "thesis".
constexpr const char* to_string(LightMode mode) {
  return mode == LightMode::thesis ? "thesis" : "fast";
}

/// Of one of these words.
inline LightMode parse_light_mode(const std::string& word) {
  return word == to_string(LightMode::thesis) ? LightMode::thesis : LightMode::fast;
}

/// Cycles that light takes from a cell to the next where nothing holds it up.
constexpr int hop_stages(LightMode mode) { return mode == LightMode::thesis ? 3 : 2; }

/// What a cell may have more than one of, for rays. RTL has this many, the cycle model others, too.
struct RayUnits {
  int looks = 4;       ///< 1, 2 (rays to the east, to the west) or 4 (one for each quadrant)
  int arithmetic = 2;  ///< 1 or 2 in which rays begin, and as many in which they meet a plane
};

/// What a machine was built for. A job may ask for less (fraction bits, L, FA), never for more.
struct MachineConfig {
  int n = 16;             ///< cells per side, voxels per column (>= 2)
  int fraction_bits = 4;  ///< f: vertices are multiples of 2^-f voxel
  int max_distance = 64;  ///< largest distance L of the virtual faces
  int max_fa = 32;        ///< deepest beam queue (FA) of a cell
  int feeders = 1;        ///< row feeders that the host port serves; a power of two <= n
  bool layers = true;     ///< columns know shown, inside and guard voxels, not only armour
  LightMode mode = LightMode::fast;
  bool counts = true;  ///< read_light() says how many targets arrived, not only if any did
  bool skips = true;   ///< in fast mode: light that can meet nothing ends early
  /// Most bounces of a ray, and places of a queue that rays travel through, in a machine that has
  /// cells for them; 0: it has none. Golden and cycle model trace whatever this says.
  int ray_depth = 0, ray_queue = 0;
  RayUnits ray_units = {};

  /// Whether the machine knows LightRule::accurate, which needs the layers.
  bool accurate_light() const { return layers && mode == LightMode::fast; }
};

constexpr int kMaxSide = 1024;       ///< largest n the 64-bit host arithmetic is proven for
constexpr int kMaxFractionBits = 8;  ///< largest f, likewise
constexpr int kFacetBits = 20;       ///< a facet number fits in this many bits
constexpr int kMaxFacets = 1 << kFacetBits;

/// Bits that hold 0 .. count-1. Asked for every packet and voxel, so not by a loop.
constexpr int bits_for(long long count) {
  return count <= 1 ? 0 : 64 - __builtin_clzll(static_cast<unsigned long long>(count - 1));
}

/// Bits of one coordinate (at least one, as in hardware).
constexpr int coordinate_bits(int n) { return n <= 2 ? 1 : bits_for(n); }

/// A gap is kept in sixteenths of a voxel, -4 .. 4 voxels (sw/machine/claim.h).
constexpr int kGapFractionBits = 4;
constexpr int kGapBits = 7;

/// What a machine keeps of a voxel's owner: core, gap, facet number.
constexpr int kClaimBits = 1 + kGapBits + kFacetBits;

/// Bits of what else a packet says of its facet: its layer, what kind of surface it is part of.
constexpr int kLayerBits = 2;
constexpr int kSurfaceBits = 2;

/// Fraction bits of a gap on its way through a box: three coefficients, each half a unit wrong, are
/// stepped n times at most, which leaves an error of 3/8 of a sixteenth.
constexpr int gap_fraction_bits(int n) { return coordinate_bits(n) + 2 + kGapFractionBits; }

/// Signed bits of such a gap. It is exact modulo eight voxels, which is all that is kept of it.
constexpr int gap_value_bits(int n) { return gap_fraction_bits(n) + kGapBits - kGapFractionBits; }

/// Signed bits of a plane coefficient: twice a projected area, at most (n * 2^f)^2, a power of two
/// that is reached when n is one and half a face of the cube is covered.
constexpr int plane_bits(int n, int f) { return 2 * (coordinate_bits(n) + f) + 2; }

/// Unsigned bits of a slab's width: at most twice the sum of three coefficients and one more.
constexpr int width_bits(int n, int f) { return plane_bits(n, f) + 1; }

/// Fraction bits of the components of an owner's normal, of which the largest is one: at any light
/// in the cube the plane is right to an eighth of a voxel (sw/machine/plane.h).
constexpr int normal_fraction_bits(int n) { return coordinate_bits(n) + 4; }

/// Signed bits of such a component.
constexpr int normal_bits(int n) { return normal_fraction_bits(n) + 2; }

/// Bits of a word's coefficient, whatever it belongs to.
constexpr int coefficient_bits(int n, int f) {
  return std::max(plane_bits(n, f), gap_value_bits(n));
}

/// Signed bits of a slab's or side's value at any cell of the grid (thesis 3.9: T, U and Ti).
constexpr int offset_bits(int n, int f) {
  return std::max(3 * coordinate_bits(n) + 2 * f + 3, gap_value_bits(n));
}

/// Signed bits of a side's coefficient: an edge of a facet, at most n * 2^f long, a power of two
/// that is reached.
constexpr int side_bits(int n, int f) { return coordinate_bits(n) + f + 2; }

/// Bits of a side's push: half of two edges, and what rounding adds.
constexpr int push_bits(int n, int f) { return coordinate_bits(n) + f + 1; }

/// Bits of the number of beams in a cell: FA, or two FIFOs of half of it and one that is served.
constexpr int queue_bits(int max_fa) { return bits_for(max_fa + 3LL); }

/// Fraction bits of 1/L, as light in lanes wants it.
constexpr int inverse_bits(const MachineConfig& config) {
  return coordinate_bits(config.n) + 2 * bits_for(config.max_distance + 1LL) + 2;
}

}  // namespace rc2
