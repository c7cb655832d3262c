#pragma once

#include "sw/lines/tunnels.h"

namespace rc2::lines {

/// The digital plane of the voxels p with 0 <= normal.p < thickness. The components of the normal
/// have no common factor, so every integer is the value normal.p of some voxel, and all that a
/// voxel sees around it follows from its value.
struct DigitalPlane {
  glm::ivec3 normal;
  int thickness;
};

/// The thesis's connectivity of the plane (2.1).
Adjacency local_connectivity(const DigitalPlane& plane);

/// Whether two neighbours by that adjacency exist of which one lies below and one above the plane:
/// a ray passes.
bool is_passed(const DigitalPlane& plane, Adjacency rays);

/// The least thickness at which no ray of that connectivity passes: the sum of the largest one, two
/// or three of the components' absolute values.
int separating_thickness(glm::ivec3 normal, Adjacency rays);

struct PlaneSearch {
  TunnelTable<DigitalPlane> by_connectivity;  ///< the thesis's table
  TunnelTable<DigitalPlane> by_separation;    ///< by the rays that the thickness promises to stop
};

/// Every plane that stops 6-connected rays, of normal (a,b,c) with largest >= a >= b >= c >= 0 and
/// of thickness up to a+b+c+1. All others are these, turned or mirrored.
PlaneSearch search_planes(int largest);

}  // namespace rc2::lines
