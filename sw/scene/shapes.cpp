#include "sw/scene/shapes.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <utility>

namespace rc2::scene {
namespace {

// Generated vertices are multiples of the finest vertex grid. What a compiler may round
// differently is far smaller, so the scene is the same everywhere.
constexpr double kGrid = 256.0;

glm::dvec3 on_grid(const glm::dvec3& p) { return glm::floor(p * kGrid + 0.5) / kGrid; }

using Triangle = std::array<glm::dvec3, 3>;  // unit vectors

std::vector<Triangle> icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::array<glm::dvec3, 12> v{{{-1, g, 0},
                                      {1, g, 0},
                                      {-1, -g, 0},
                                      {1, -g, 0},
                                      {0, -1, g},
                                      {0, 1, g},
                                      {0, -1, -g},
                                      {0, 1, -g},
                                      {g, 0, -1},
                                      {g, 0, 1},
                                      {-g, 0, -1},
                                      {-g, 0, 1}}};
  constexpr int kFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  std::vector<Triangle> faces;
  for (const auto& f : kFaces)
    faces.push_back({glm::normalize(v[f[0]]), glm::normalize(v[f[1]]), glm::normalize(v[f[2]])});
  return faces;
}

std::vector<Triangle> split(const std::vector<Triangle>& faces) {
  std::vector<Triangle> result;
  result.reserve(4 * faces.size());
  for (const auto& [a, b, c] : faces) {
    const glm::dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c),
                     ca = glm::normalize(c + a);
    result.insert(result.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

// 6 * 2^halvings directions round a circle, by square roots only (see random_rotation).
std::vector<glm::dvec2> circle(int halvings) {
  const double h = 0.5 * std::sqrt(3.0);
  std::vector<glm::dvec2> directions = {{1, 0},  {0.5, h},   {-0.5, h},
                                        {-1, 0}, {-0.5, -h}, {0.5, -h}};
  for (; halvings > 0; --halvings) {
    std::vector<glm::dvec2> finer;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      finer.push_back(directions[i]);
      finer.push_back(glm::normalize(directions[i] + directions[(i + 1) % directions.size()]));
    }
    directions = std::move(finer);
  }
  return directions;
}

}  // namespace

void add_box(Scene& scene, const Box& box, std::uint32_t material, bool inwards) {
  const auto corner = [&](double u, double v, double w) {
    return on_grid(box.centre + box.axes * (glm::dvec3(u, v, w) * box.half_size));
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      // (u, v, axis) are cyclic, so going u then v turns counter-clockwise seen from the + side.
      const bool reversed = (side < 0.0) != inwards;
      const double uv[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      std::vector<glm::dvec3> corners;
      for (int k = 0; k < 4; ++k) {
        const double* at = uv[reversed ? 3 - k : k];
        glm::dvec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = at[0];
        p[(axis + 2) % 3] = at[1];
        corners.push_back(corner(p.x, p.y, p.z));
      }
      scene.add(corners, material);
    }
  }
}

void add_tile(Scene& scene, const glm::dvec2& low_and_size, const Tile& tile,
              std::uint32_t material) {
  const auto corner = [&](int u, int v) {
    glm::dvec3 share;
    share[tile.axis] = tile.side;
    share[(tile.axis + 1) % 3] = static_cast<double>(tile.u + u) / tile.parts;
    share[(tile.axis + 2) % 3] = static_cast<double>(tile.v + v) / tile.parts;
    return on_grid(low_and_size.x + low_and_size.y * share);
  };
  // As in add_box, u then v is counter-clockwise seen from the + side.
  if (tile.side == 0)
    scene.add({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, material);
  else
    scene.add({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)}, material);
}

void add_sphere(Scene& scene, const glm::dvec3& centre, double radius, double edge,
                std::uint32_t material, int max_level) {
  std::vector<Triangle> faces = icosahedron();
  double length = glm::length(faces[0][0] - faces[0][1]) * radius;
  for (int level = 0; level < max_level && length > edge * std::sqrt(2.0); ++level) {
    faces = split(faces);
    length /= 2.0;
  }
  for (const auto& [a, b, c] : faces)
    scene.add(
        {on_grid(centre + radius * a), on_grid(centre + radius * b), on_grid(centre + radius * c)},
        material);
}

void add_torus(Scene& scene, const Torus& torus, std::uint32_t material) {
  const std::vector<glm::dvec2> around = circle(2), across = circle(1);
  const auto corner = [&](std::size_t i, std::size_t j) {
    const glm::dvec2 &u = around[i % around.size()], &v = across[j % across.size()];
    const double reach = torus.ring + torus.tube * v.x;
    return on_grid(torus.centre +
                   torus.axes * glm::dvec3(reach * u.x, reach * u.y, torus.tube * v.y));
  };
  for (std::size_t i = 0; i < around.size(); ++i) {
    for (std::size_t j = 0; j < across.size(); ++j) {
      const glm::dvec3 a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                       d = corner(i, j + 1);
      scene.add({a, b, c}, material);
      scene.add({a, c, d}, material);
    }
  }
}

void add_tetrahedron(Scene& scene, const std::array<glm::dvec3, 4>& corners,
                     std::uint32_t material) {
  std::array<glm::dvec3, 4> at;
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = on_grid(corners[i]);
  if (glm::dot(glm::cross(at[1] - at[0], at[2] - at[0]), at[3] - at[0]) > 0)
    std::swap(at[1], at[2]);
  constexpr int kSides[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  for (const auto& side : kSides) scene.add({at[side[0]], at[side[1]], at[side[2]]}, material);
}

void add_random_triangles(Scene& scene, int count, int n, Random& random, std::uint32_t material) {
  for (int i = 0; i < count; ++i) {
    std::vector<glm::dvec3> corners(3);
    for (glm::dvec3& corner : corners)
      for (int axis = 0; axis < 3; ++axis) corner[axis] = random.between(0, n - 1);
    scene.add(corners, material);
  }
}

glm::dmat3 random_rotation(Random& random) {
  for (;;) {
    const double w = random.between(-1, 1), x = random.between(-1, 1), y = random.between(-1, 1),
                 z = random.between(-1, 1);
    const double length = w * w + x * x + y * y + z * z;
    if (length > 0.01 && length < 1.0)
      return glm::mat3_cast(glm::normalize(glm::dquat(w, x, y, z)));
  }
}

}  // namespace rc2::scene
