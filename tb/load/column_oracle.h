// Which voxels of a column belong to a facet, decided from the geometry, fast enough for millions
// of facets. Nothing here knows the constants of a packet, and nothing is divided or rounded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"

namespace rc2::facet {

/// Voxels first..last, none if first > last.
struct Span {
  int first, last;

  bool operator==(const Span& other) const {
    return (first > last && other.first > other.last) ||
           (first == other.first && last == other.last);
  }
};

/// What a facet has of a column: its voxels, and of those the ones whose centre lies within its
/// border, seen along the axis (supercover: the axes) in which its sides are given.
struct Column {
  Span voxels, core;

  bool operator==(const Column& other) const {
    return voxels == other.voxels && core == other.core;
  }
};

/// A rule's definition as half-spaces that hold the voxel's centre, each pushed out as far as the
/// farthest end of what must meet the facet: half axes (naive), half diagonals of the voxel
/// (armoured), the whole voxel by separating axes (supercover).
///
/// Lengths are counted in 2^-f/2 voxel, at most n 2^f 2 <= 2^19 of them. A normal is at most 2^39,
/// its product with a length at most 3 * 2^58: 64 bits are enough. Rule blindee multiplies by the
/// normal once more, 2^99, and needs 128. Any other type with sign serves to check these two.
template <typename Integer>
class ColumnOracle {
 public:
  /// A planar convex polygon that has an area, in units of 1/one voxel, any orientation; collinear
  /// and repeated vertices may be among its own.
  ColumnOracle(const Border& border, std::int64_t one, Rule rule);

  /// Column (x, y) of a cube of n voxels.
  Column column(int x, int y, int n) const;

 private:
  using Point = std::array<Integer, 3>;

  // Points p where towards . (p - from) + reach >= 0.
  struct HalfSpace {
    Point towards, from;
    Integer reach;
    bool keeps_border;
  };
  using HalfSpaces = std::vector<HalfSpace>;

  static Integer dot(const Point& a, const Point& b);
  static Point cross(const Point& a, const Point& b);
  static Point minus(const Point& a, const Point& b);

  Integer farthest(const Point& towards) const;
  void add(HalfSpaces& spaces, const Point& towards, const Point& from, const Integer& reach);
  void add_slab(const Point& normal);
  void add_sides(const Point& normal);
  void add_shadow(const Point& axis, bool bounds_core);
  Span narrowed(Span span, const HalfSpaces& spaces, int x, int y) const;

  Rule rule_;
  Integer voxel_;
  std::vector<Point> vertices_;
  std::vector<Point> ends_;  // of what must meet the facet, from the voxel's centre
  HalfSpaces all_, core_;    // the voxel's own, and what its core has besides
};

__extension__ using Int128 = __int128;

extern template class ColumnOracle<std::int64_t>;
extern template class ColumnOracle<Int128>;

}  // namespace rc2::facet
