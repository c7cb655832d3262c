// Which voxels a facet has, decided from the geometry in exact integers of any size: cubes, squares
// and segments around a voxel's centre that meet the facet's plane and sides. Nothing here knows
// the constants of a packet.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"

namespace rc2::facet {

class Oracle {
 public:
  /// A planar convex polygon in units of 1/one voxel, any orientation.
  Oracle(const Border& border, std::int64_t one, Rule rule);

  /// Whether the voxel belongs to the facet.
  bool has(const glm::ivec3& voxel) const;

 private:
  using Integer = boost::multiprecision::checked_int256_t;
  struct Point {
    std::array<Integer, 3> c;
  };

  static Integer dot(const Point& a, const Point& b);
  static Point cross(const Point& a, const Point& b);
  static Point minus(const Point& a, const Point& b);
  int side_of(const Point& direction, const Point& through, const Point& p) const;
  bool meets_plane(const Point& p) const;
  bool meets_sides(const Point& p) const;
  bool meets_box(const Point& p) const;
  bool is_in_thick_polygon(const Point& p) const;
  bool touches_cube(const Point& p) const;

  Rule rule_;
  Integer half_;                 // half a voxel
  std::vector<Point> vertices_;  // in units of half a vertex step
  std::vector<Point> reach_;     // from a voxel's centre to the ends of what must meet the facet
  std::vector<Point> inwards_;   // per side, in the dominant projection
  std::vector<Point> axes_;      // along which cube and polygon may be separated
  Point normal_, low_, high_;
  Integer thickness_, thickness_divisor_;
};

}  // namespace rc2::facet
