// Closed meshes in voxel coordinates, outside counter-clockwise, for the generated scenes.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "sw/scene/random.h"
#include "sw/scene/scene.h"

namespace rc2::scene {

/// A box with its middle at `centre`, its axes the columns of `axes`.
struct Box {
  glm::dvec3 centre, half_size;
  glm::dmat3 axes{1.0};
};

/// Adds the six sides of a box as quads; inwards turns them to face the middle.
void add_box(Scene& scene, const Box& box, std::uint32_t material, bool inwards = false);

/// One of parts * parts squares of a side of a cube that is seen from within.
struct Tile {
  int axis, side;  ///< of the cube: axis 0 .. 2, side 0 or 1 along it
  int u, v;        ///< place along the next two axes, 0 .. parts-1
  int parts;
};

/// Adds a tile of the cube whose low corner is `low` in every axis. Tiles share their corners, so
/// all of a cube's make a closed surface.
void add_tile(Scene& scene, const glm::dvec2& low_and_size, const Tile& tile,
              std::uint32_t material);

constexpr int kMaxSphereLevel = 5;  ///< 20 * 4^5 = 20480 triangles

/// Adds an icosahedron each of whose triangles is split in four until edges are about `edge` long,
/// at most `max_level` times; all vertices lie on the sphere.
void add_sphere(Scene& scene, const glm::dvec3& centre, double radius, double edge,
                std::uint32_t material, int max_level = kMaxSphereLevel);

/// A torus round the third of its axes. `ring` is the radius of the circle that the middle of the
/// tube follows, `tube` < `ring` the radius of the tube.
struct Torus {
  glm::dvec3 centre;
  double ring, tube;
  glm::dmat3 axes{1.0};
};

/// Adds a torus of 24 x 12 quadrangles, each cut into two triangles.
void add_torus(Scene& scene, const Torus& torus, std::uint32_t material);

/// Adds the four sides of a tetrahedron, whatever the order of its corners. Corners are rounded to
/// the finest vertex grid; those in one plane give sides of either orientation.
void add_tetrahedron(Scene& scene, const std::array<glm::dvec3, 4>& corners,
                     std::uint32_t material);

/// Adds triangles with corners anywhere between the centres of an n-cube's voxels.
void add_random_triangles(Scene& scene, int count, int n, Random& random, std::uint32_t material);

/// A rotation from all of them, by square roots only: sine and cosine differ between mathematics
/// libraries.
glm::dmat3 random_rotation(Random& random);

}  // namespace rc2::scene
