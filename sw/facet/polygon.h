// Exact geometry of polygons whose vertices are integers (multiples of 2^-f voxel).
#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/vector_int3_sized.hpp>
#include <vector>

namespace rc2::facet {

/// Vertices stay below 2^19, so products of three differences fit into 64 bits.
using Vertex = glm::i64vec3;
using Border = std::vector<Vertex>;
using Triangle = std::array<Vertex, 3>;

inline Vertex cross(const Vertex& a, const Vertex& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline std::int64_t dot(const Vertex& a, const Vertex& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Rules that are not closed look at p + (e, e^2, e^3) with e -> 0+: no point is then on a bound,
/// so facets that share a side agree on every voxel. Whether a point on the bound direction . p >=
/// d stays: if the first coefficient that is not 0 is positive.
inline bool keeps_ties(const Vertex& direction) {
  return (direction.x != 0 ? direction.x : (direction.y != 0 ? direction.y : direction.z)) > 0;
}

/// Axis of the largest component; z before y before x when equal, because sides projected along z
/// do not depend on z and cost a cell no division.
int dominant_axis(const Vertex& normal);

/// Drops repeated vertices, vertices between collinear neighbours, and spikes, until none is left.
/// Fewer than three vertices remain of a polygon without area.
void clean(Border& border);

/// Normal by the right-hand rule, its length twice the area (of the projection if not planar).
Vertex doubled_area(const Border& border);

/// Whether a clean border is exactly planar, convex and goes round once.
bool is_planar_convex(const Border& border);

/// Cuts ears off the border (projected along its dominant axis) and appends the triangles, same
/// orientation. Every side of the border belongs to exactly one of them, whatever its shape.
void triangulate(const Border& border, std::vector<Triangle>& triangles);

}  // namespace rc2::facet
