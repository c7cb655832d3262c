// The size of a machine, and every integer width that follows from it.
//
// rtl/rc2_pkg.sv derives the same widths for the hardware; the hardware reports its own through
// its capability registers and the host refuses to talk to a machine whose numbers differ.
#pragma once

namespace rc2 {

/// What a machine was built for. A job may ask for less (fraction bits, L, FA), never for more.
struct MachineConfig {
  int n = 16;             ///< cells per side, voxels per column (>= 2)
  int fraction_bits = 4;  ///< f: vertices are multiples of 2^-f voxel
  int max_distance = 64;  ///< largest distance L of the virtual faces
  int max_fa = 32;        ///< deepest beam queue (FA) of a cell
};

constexpr int kMaxSide = 1024;       ///< largest n the 64-bit host arithmetic is proven for
constexpr int kMaxFractionBits = 8;  ///< largest f, likewise
constexpr int kFacetBits = 20;       ///< a facet number fits in this many bits
constexpr int kMaxFacets = 1 << kFacetBits;

/// Bits that hold 0 .. count-1.
constexpr int bits_for(long long count) {
  int bits = 0;
  while ((1LL << bits) < count) ++bits;
  return bits;
}

/// Bits of one coordinate (at least one, as in hardware).
constexpr int coordinate_bits(int n) { return n <= 2 ? 1 : bits_for(n); }

/// Signed bits of a plane coefficient: twice a projected area, at most (n * 2^f)^2, a power of two
/// that is reached when n is one and half a face of the cube is covered.
constexpr int coefficient_bits(int n, int f) { return 2 * (coordinate_bits(n) + f) + 2; }

/// Signed bits of a bound's offset at any cell of the grid (thesis 3.9: T and U).
constexpr int offset_bits(int n, int f) { return 3 * coordinate_bits(n) + 2 * f + 3; }

}  // namespace rc2
