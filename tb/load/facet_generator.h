// Planar convex facets that look for trouble: thin, flat, tiny, huge, on ties, on each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sw/facet/polygon.h"

namespace rc2::facet {

/// The cube [-1/2, n-1/2]^3 in vertex units of 2^-f voxel.
struct Cube {
  int n, fraction_bits;

  std::int64_t one() const { return std::int64_t{1} << fraction_bits; }
  std::int64_t low() const { return -(one() / 2); }
  std::int64_t high() const { return n * one() - (one() + 1) / 2; }
  std::int64_t extent() const { return high() - low(); }
};

/// Sizes are spread evenly over their number of binary digits, from one vertex unit to the cube, in
/// all classes but the last three.
enum class FacetClass {
  random,        ///< triangles
  sliver,        ///< triangles, longest side / height up to 10^6 and beyond
  edge_on,       ///< triangles and trapezia whose plane holds an axis
  half_integer,  ///< vertices on half voxels, most planes along axes or diagonals: ties everywhere
  collinear,     ///< vertices between collinear neighbours or repeated; some have no area at all
  duplicates,    ///< one facet, begun elsewhere, turned over, and moved within its plane
  many_sided,    ///< 3 to 16 sides
  single_voxel,  ///< within one voxel
  full_cube      ///< walls, ramps, hexagons and triangles between the borders of the cube
};

inline constexpr std::array kFacetClasses{
    FacetClass::random,       FacetClass::sliver,       FacetClass::edge_on,
    FacetClass::half_integer, FacetClass::collinear,    FacetClass::duplicates,
    FacetClass::many_sided,   FacetClass::single_voxel, FacetClass::full_cube};

const char* to_string(FacetClass kind);

/// One facet of the class, or the four of `duplicates`: planar, convex, any orientation, within the
/// cube. Every one has an area, but for some of `collinear`. The same with every library.
std::vector<Border> generate_facets(FacetClass kind, const Cube& cube, std::uint64_t seed);

}  // namespace rc2::facet
