// What build_facets saw on its way, for those who need more of a scene than its packets.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"

namespace rc2::facet {

struct Traced {
  /// A planar convex part of a polygon.
  struct Piece {
    Border border;
    Vertex normal;
    std::uint32_t polygon;
    std::optional<std::uint32_t> facet;  ///< its number; none if it has no voxel of the cube
  };

  /// The polygons that lie within the cube, rounded: polygon i has the corners
  /// first[i] .. first[i+1]-1. Their sides cancel where the mesh is closed; the pieces' sides need
  /// not, because they leave out vertices on straight lines.
  std::vector<Vertex> corners;
  std::vector<std::size_t> first{0};
  std::vector<Piece> pieces;

  std::size_t polygon_count() const { return first.size() - 1; }
};

/// build_facets, and a trace of what it made the packets of.
FacetSet build_facets(const scene::Scene& scene, int n, int fraction_bits, Rule rule,
                      Traced& traced);

}  // namespace rc2::facet
