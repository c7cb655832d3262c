// Closed meshes in voxel coordinates, outside counter-clockwise, for the generated scenes.
#pragma once

#include <glm/mat3x3.hpp>

#include "sw/scene/scene.h"

namespace rc2::scene {

/// A box with its middle at `centre`, its axes the columns of `axes`.
struct Box {
  glm::dvec3 centre, half_size;
  glm::dmat3 axes{1.0};
};

/// Adds the six sides of a box as quads; inwards turns them to face the middle.
void add_box(Scene& scene, const Box& box, std::uint32_t material, bool inwards = false);

/// Adds an icosahedron each of whose triangles is split in four until edges are about `edge` long,
/// at most kMaxSphereLevel times; all vertices lie on the sphere.
void add_sphere(Scene& scene, const glm::dvec3& centre, double radius, double edge,
                std::uint32_t material);

constexpr int kMaxSphereLevel = 5;  ///< 20 * 4^5 = 20480 triangles

}  // namespace rc2::scene
