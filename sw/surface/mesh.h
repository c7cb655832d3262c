// A scene's polygons after rounding: exact geometry for what is compared with the machine.
#pragma once

#include <vector>

#include "sw/facet/polygon.h"
#include "sw/scene/scene.h"

namespace rc2::surface {

struct Mesh {
  int fraction_bits;                  ///< vertices are in units of 2^-fraction_bits voxel
  std::vector<facet::Border> facets;  ///< planar, convex, with area
  bool closed;                        ///< see quantise
};

/// Rounds the scene (voxel coordinates, all vertices finite and within the cube of side kMaxSide)
/// to 2^-fraction_bits and splits its polygons exactly as facet::build_facets does, so that both
/// speak of the same surface. It is closed if every side is used as often in one direction as in
/// the other: then it is a boundary, and winding numbers change only where it is crossed. Vertices
/// that fall together are one vertex.
Mesh quantise(const scene::Scene& scene, int fraction_bits);

}  // namespace rc2::surface
