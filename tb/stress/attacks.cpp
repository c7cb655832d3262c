#include "tb/stress/attacks.h"

#include <algorithm>
#include <glm/common.hpp>

namespace rc2::stress {
namespace {

using facet::cross;
using facet::dot;
using facet::FacetClass;
using facet::generate_facets;
using facet::Vertex;

constexpr std::size_t kFacets =
    12;  // of a scene: enough to meet, few enough to leave room for lights

Vertex clamped(const Vertex& v, const Cube& cube) {
  return glm::clamp(v, Vertex(cube.low()), Vertex(cube.high()));
}

Vertex random_vertex(const Cube& cube, Dice& dice) {
  const std::int64_t x = dice.roll(cube.low(), cube.high());
  const std::int64_t y = dice.roll(cube.low(), cube.high());
  return {x, y, dice.roll(cube.low(), cube.high())};
}

template <FacetClass kind>
std::vector<Border> draw_class(const Cube& cube, Dice& dice) {
  std::vector<Border> facets;
  while (facets.size() < kFacets)
    for (Border& border : generate_facets(kind, cube, dice.bits()))
      facets.push_back(std::move(border));
  return facets;
}

// The cube's length by one vertex unit, and lattice triangles, which can be thinner still.
std::vector<Border> draw_needles(const Cube& cube, Dice& dice) {
  std::vector<Border> facets;
  while (facets.size() < kFacets) {
    const int axis = static_cast<int>(dice.roll(0, 2));
    Vertex from = random_vertex(cube, dice), to = random_vertex(cube, dice);
    from[axis] = cube.low();
    to[axis] = cube.high();
    Vertex beside = dice.one_in(2) ? to : (from + to) / std::int64_t{2};
    beside[(axis + 1) % 3] += dice.one_in(2) ? 1 : -1;
    facets.push_back({from, to, clamped(beside, cube)});
  }
  return facets;
}

// One triangle, and the same with one vertex moved by one unit: planes that hardly differ.
std::vector<Border> draw_near_parallel(const Cube& cube, Dice& dice) {
  const Border first = generate_facets(FacetClass::random, cube, dice.bits())[0];
  std::vector<Border> facets{first};
  while (facets.size() < kFacets) {
    Border moved = first;
    Vertex& vertex = moved[static_cast<std::size_t>(dice.roll(0, 2))];
    vertex[static_cast<int>(dice.roll(0, 2))] += dice.one_in(2) ? 1 : -1;
    vertex = clamped(vertex, cube);
    if (dice.one_in(2)) std::reverse(moved.begin(), moved.end());
    facets.push_back(moved);
  }
  return facets;
}

// Every coordinate at an end of its range or one unit from it.
std::vector<Border> draw_ends(const Cube& cube, Dice& dice) {
  const auto end = [&] {
    const std::int64_t inwards = dice.roll(0, 1);
    return dice.one_in(2) ? cube.low() + inwards : cube.high() - inwards;
  };
  std::vector<Border> facets;
  while (facets.size() < kFacets) {
    Border border;
    for (int i = 0; i < 3; ++i) {
      const std::int64_t x = end(), y = end();
      border.emplace_back(x, y, end());
    }
    facets.push_back(border);
  }
  return facets;
}

// Points, lines, lines there and back: whatever has no area, among some that have.
std::vector<Border> draw_degenerate(const Cube& cube, Dice& dice) {
  std::vector<Border> facets;
  while (facets.size() < kFacets) {
    const Vertex a = random_vertex(cube, dice), b = random_vertex(cube, dice);
    switch (dice.roll(0, 3)) {
      case 0:
        facets.push_back({a, a, a});
        break;
      case 1:
        facets.push_back({a, b, a});
        break;
      case 2:
        facets.push_back({a, b, b, a, b});
        break;
      default:
        facets.push_back(generate_facets(FacetClass::collinear, cube, dice.bits())[0]);
    }
  }
  return facets;
}

// Many facets in a few voxels.
std::vector<Border> draw_crowd(const Cube& cube, Dice& dice) {
  const Vertex middle = random_vertex(cube, dice);
  std::vector<Border> facets;
  while (facets.size() < 5 * kFacets) {
    Border border;
    for (int i = 0; i < 3; ++i) {
      const Vertex corner = random_vertex(cube, dice);
      border.push_back(clamped(middle + (corner - middle) / std::int64_t{cube.n}, cube));
    }
    facets.push_back(border);
  }
  return facets;
}

std::vector<Border> box(const Vertex& low, const Vertex& high) {
  std::vector<Border> sides;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool is_high : {false, true}) {
      Border side(4, low);
      for (Vertex& corner : side) corner[axis] = is_high ? high[axis] : low[axis];
      side[1][u] = side[2][u] = high[u];
      side[2][v] = side[3][v] = high[v];
      if (!is_high) std::reverse(side.begin(), side.end());
      sides.push_back(side);
    }
  }
  return sides;
}

// Boxes along the axes, some of them a unit thick, some in each other, some large enough for a
// light.
std::vector<Body> draw_boxes(const Cube& cube, Dice& dice) {
  std::vector<Body> bodies;
  for (std::int64_t count = dice.roll(1, 4); count > 0; --count) {
    Vertex low = random_vertex(cube, dice), high = random_vertex(cube, dice);
    if (dice.one_in(3)) low = Vertex(cube.low()), high = Vertex(cube.high());
    for (int axis = 0; axis < 3; ++axis) {
      if (dice.one_in(6)) high[axis] = low[axis] + 1;
      if (low[axis] > high[axis]) std::swap(low[axis], high[axis]);
      if (low[axis] == high[axis]) --low[axis];
    }
    if (clamped(low, cube) != low || clamped(high, cube) != high) continue;
    bodies.push_back(box(low, high));
  }
  return bodies;
}

// Tetrahedra, half of them with the fourth vertex a few units from the plane of the others.
std::vector<Body> draw_tetrahedra(const Cube& cube, Dice& dice) {
  std::vector<Body> bodies;
  for (int count = 0; count < 3; ++count) {
    Vertex a = random_vertex(cube, dice), b = random_vertex(cube, dice),
           c = random_vertex(cube, dice), d = random_vertex(cube, dice);
    if (dice.one_in(2)) {
      d = (a + b + c) / std::int64_t{3};
      const int axis = static_cast<int>(dice.roll(0, 2));
      d[axis] = std::clamp(d[axis] + dice.roll(-2, 2), cube.low(), cube.high());
    }
    const std::int64_t volume = dot(cross(b - a, c - a), d - a);
    if (volume == 0) continue;
    if (volume > 0) std::swap(b, c);
    bodies.push_back({{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}});
  }
  return bodies;
}

template <std::vector<Border> (*draw)(const Cube&, Dice&)>
std::vector<Body> as_one(const Cube& cube, Dice& dice) {
  return {draw(cube, dice)};
}

template <FacetClass kind>
constexpr auto kOfClass = as_one<draw_class<kind>>;

}  // namespace

const std::vector<Attack>& attacks() {
  static const std::vector<Attack> all{
      {"slivers", "longest side / height up to 10^6", false, kOfClass<FacetClass::sliver>},
      {"needles", "from face to face of the cube, one unit wide", false, as_one<draw_needles>},
      {"near-parallel planes", "one triangle, its vertices one unit off", false,
       as_one<draw_near_parallel>},
      {"ends of the range", "coordinates -1/2, n - 1/2 and a unit inwards", false,
       as_one<draw_ends>},
      {"across the cube", "walls, ramps, hexagons from border to border", false,
       kOfClass<FacetClass::full_cube>},
      {"voxel borders", "vertices on half voxels, planes along axes and diagonals", false,
       kOfClass<FacetClass::half_integer>},
      {"edge-on", "planes that hold an axis", false, kOfClass<FacetClass::edge_on>},
      {"duplicates", "the same facet again, turned over, moved in its plane", false,
       kOfClass<FacetClass::duplicates>},
      {"many sides", "3 to 16 sides", false, kOfClass<FacetClass::many_sided>},
      {"within a voxel", "facets smaller than a voxel", false, kOfClass<FacetClass::single_voxel>},
      {"crowd", "sixty facets in a few voxels", false, as_one<draw_crowd>},
      {"no area", "points, lines, spikes, repeated vertices", false, as_one<draw_degenerate>},
      {"boxes", "closed, in each other, down to a unit thick", true, draw_boxes},
      {"tetrahedra", "closed, down to a unit from flat", true, draw_tetrahedra},
  };
  return all;
}

}  // namespace rc2::stress
