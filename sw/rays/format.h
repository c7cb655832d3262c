// The numbers that a ray is made of, and how wide they have to be.
//
// Everything is an integer and every product is cut off once, where it is made, so that a picture
// does not depend on the order of messages. docs/render.md has the widths in a table.
#pragma once

#include "sw/base/config.h"

namespace rc2::rays {

/// Fraction bits of a place: 1/64 voxel, a quarter of what a voxel knows of its plane (a gap is
/// kept in sixteenths).
constexpr int kPlaceFraction = 6;
constexpr int kPlaceOne = 1 << kPlaceFraction;

/// Fraction bits of a normal in slope form, its largest component being 1: off by 1/2048 radian at
/// most, a sixth of a voxel over 128 cells after the reflection.
constexpr int kNormalFraction = 10;
constexpr int kNormalOne = 1 << kNormalFraction;
/// Signed bits of the two smaller components, -1 and 1 included.
constexpr int kNormalBits = kNormalFraction + 2;

/// Fraction bits of a ratio of refractive indices, and the largest ratio.
constexpr int kIndexFraction = 12;
constexpr int kIndexOne = 1 << kIndexFraction;
constexpr int kMaxIndex = 4;

/// Shares of light that a facet reflects or lets through, in 1/256.
constexpr int kShareFraction = 8;
constexpr int kShareOne = 1 << kShareFraction;

/// What a ray is worth to its pixel, in 1/4096: the product of the shares on its way.
constexpr int kWeightFraction = 12;
constexpr int kWeightOne = 1 << kWeightFraction;

/// Bounces at most: a node of the tree fits in 8 bits.
constexpr int kMaxDepth = 7;

/// Fraction bits of a direction, a unit vector: over n cells it strays by 1/32 voxel at most.
constexpr int direction_fraction(int n) { return coordinate_bits(n) + 5; }

/// Signed bits of a direction's component, -1 and 1 included.
constexpr int direction_bits(int n) { return direction_fraction(n) + 2; }

/// Signed bits of a place in the cube: -1/2 .. n - 1/2.
constexpr int place_bits(int n) { return coordinate_bits(n + 1) + kPlaceFraction + 1; }

/// Fraction bits of dz/dx and dz/dy, which only the walk uses: cut off, they leave the z of the
/// last column 1/2 voxel short at most; a hit does not depend on them.
constexpr int slope_fraction(int n) { return std::max(coordinate_bits(n) + 1, kPlaceFraction); }

/// A slope is not told from a steeper one beyond this: a ray of that slope leaves the cube before
/// it leaves a column that it enters.
constexpr int steepest(int n) { return 2 << coordinate_bits(n); }

/// Signed bits of a slope and of a height at which a ray leaves a column.
constexpr int slope_bits(int n) { return slope_fraction(n) + coordinate_bits(n) + 3; }

/// Signed bits of the decision between x and y: |E| <= |d| times one cell.
constexpr int decision_bits(int n) { return direction_fraction(n) + kPlaceFraction + 2; }

/// Signed bits of a ray's height over a plane (1/64 voxel times 1/1024), three terms of n voxels.
constexpr int height_bits(int n) {
  return coordinate_bits(n) + kPlaceFraction + kNormalFraction + 3;
}

/// Bits of height over approach with a fraction of direction_fraction(n) + 1: beyond that a ray has
/// left the cube, along each axis in which it moves at all.
constexpr int meeting_bits(int n) { return direction_fraction(n) + 1 + place_bits(n); }

}  // namespace rc2::rays
