// Whether and where a ray meets the plane of a voxel's owner: "facing and exit".
//
// A ray stops in an armoured voxel whose owner faces it and whose plane it has reached when it
// leaves the voxel. So armour in front of the surface is passed, a ray leaves its own surface
// without any rule for that (it does not face it), and the hit is on the plane itself.
#pragma once

#include <cstdint>
#include <optional>

#include "sw/rays/ray.h"

namespace rc2::rays {

/// The plane of a voxel's owner, turned to face the ray.
struct Face {
  glm::ivec3 normal;
  /// The ray's origin over the plane, along the normal's largest axis: 1/64 voxel times 1/1024.
  std::int64_t height;
  /// How fast the ray comes nearer, > 0: direction's unit times 1/1024.
  std::int64_t approach;
  bool is_back;  ///< the ray sees the facet's inner side
};

/// What a voxel says of its owner.
struct Owned {
  glm::ivec3 voxel;
  const Facet& facet;
  bool core;  ///< of the owner's claim (sw/machine/claim.h)
  int gap;    ///< likewise, in sixteenths
};

/// How the ray sees the owner's plane; none if it cannot stop there. A solid stops rays in its
/// facets' cores only: outside of them its armour stands out over its silhouette.
std::optional<Face> face(const Ray& ray, const Owned& owned);

/// The side through which the ray leaves a voxel, after going `way` (1/64 voxel) along the axis, as
/// a face: for the safety net, where no plane will do (thesis 5.2.2).
Face side_face(const Ray& ray, int axis, std::int64_t way);

/// Whether the ray is in front of the owner's plane then. Exact.
bool is_in_front(const Ray& ray, const Owned& owned, int axis, std::int64_t way);

/// Whether the ray, after going `way` (1/64 voxel) along the axis, has reached the plane. Exact.
inline bool is_reached(const Ray& ray, const Face& face, int axis, std::int64_t way) {
  return face.height * std::abs(ray.direction[axis]) <= face.approach * way;
}

/// Where the ray meets the plane, in 1/64 voxel, off by one of that at most: one division. Its
/// origin, if that is behind the plane. If it does so far outside the cube, some place out there,
/// in the same direction along each axis.
glm::ivec3 meeting_point(const Ray& ray, const Face& face, int n);

}  // namespace rc2::rays
