#include "tb/load/facet_generator.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

#include "tb/load/dice.h"
#include "tb/load/lattice_polygon.h"

namespace rc2::facet {
namespace {

// Arguments that roll dice stand in braces: only there is their order the same everywhere.
class Generator {
 public:
  Generator(const Cube& cube, std::uint64_t seed) : cube_(cube), dice_(seed) {}

  std::vector<Border> generate(FacetClass kind) {
    if (kind == FacetClass::duplicates) return duplicates();
    Border border;
    do {
      border = one_of(kind);
    } while (doubled_area(border) == Vertex(0));
    if (kind == FacetClass::collinear) add_superfluous(border);
    return {border};
  }

 private:
  Border one_of(FacetClass kind) {
    switch (kind) {
      case FacetClass::sliver:
        return sliver();
      case FacetClass::edge_on:
        return edge_on();
      case FacetClass::half_integer:
        return half_integer();
      case FacetClass::collinear:
      case FacetClass::many_sided:
        return many_sided();
      case FacetClass::single_voxel:
        return single_voxel();
      case FacetClass::full_cube:
        return full_cube();
      default:
        return triangle();
    }
  }

  // How large a facet is to be, along each axis.
  Vertex random_size() {
    const std::int64_t size = dice_.roll_size(cube_.extent());
    if (dice_.one_in(2)) return Vertex(size);
    return {size, dice_.roll_size(cube_.extent()), dice_.roll_size(cube_.extent())};
  }

  Vertex random_in(const Vertex& low, const Vertex& high) {
    return {dice_.roll(low.x, high.x), dice_.roll(low.y, high.y), dice_.roll(low.z, high.z)};
  }

  // Somewhere in the cube, in steps of `step`; the facet must fit, its vertices may be anywhere.
  Border placed(Border border, std::int64_t step = 1) {
    Vertex low = border[0], high = border[0];
    for (const Vertex& v : border) {
      low = glm::min(low, v);
      high = glm::max(high, v);
    }
    const Vertex room = (Vertex(cube_.extent()) - (high - low)) / step;
    const Vertex move = Vertex(cube_.low()) - low + step * random_in(Vertex(0), room);
    for (Vertex& v : border) v += move;
    return border;
  }

  bool fits(const Border& border) const {
    Vertex low = border[0], high = border[0];
    for (const Vertex& v : border) {
      low = glm::min(low, v);
      high = glm::max(high, v);
    }
    const Vertex size = high - low;
    return std::max({size.x, size.y, size.z}) <= cube_.extent();
  }

  Border triangle() {
    const Vertex size = random_size();
    return placed(
        {random_in(Vertex(0), size), random_in(Vertex(0), size), random_in(Vertex(0), size)});
  }

  // a, a + m*g + e, a + k*g with a small e: k/m of |e| high.
  Border sliver() {
    for (;;) {
      const Vertex size = random_size();
      const std::int64_t steps = dice_.roll_size(std::max({size.x, size.y, size.z}));
      const Vertex reach = glm::max(size / steps, Vertex(1));
      const Vertex step = random_in(-reach, reach);
      const Vertex bend = random_in(Vertex(-1), Vertex(1));
      const Border border{Vertex(0), steps * step + bend, dice_.roll_size(steps) * step};
      if (fits(border)) return placed(border);
    }
  }

  Border edge_on() {
    const int axis = static_cast<int>(dice_.roll(0, 2));
    for (;;) {
      const Vertex size = random_size();
      Vertex across = random_in(-size, size), up(0), down(0);
      up[axis] = dice_.roll(0, size[axis]);
      down[axis] = -dice_.roll(0, size[axis]);
      Border border{Vertex(0), across, up};
      if (dice_.one_in(2)) {
        across[axis] = 0;
        border = {up, down, across, across + up};
      }
      if (fits(border)) return placed(border);
    }
  }

  Border half_integer() {
    const std::int64_t half = std::max<std::int64_t>(1, cube_.one() / 2);
    const std::int64_t extent = cube_.extent() / half;
    const auto wide = [&] { return half * dice_.roll_size(extent); };
    const int axis = static_cast<int>(dice_.roll(0, 2)), u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vertex a(0), b(0), c(0);
    switch (dice_.roll(0, 3)) {
      case 0:  // along the axes
        a[u] = wide();
        b[v] = wide();
        return placed({Vertex(0), a, a + b, b}, half);
      case 1:
        a[u] = wide();
        b[v] = wide();
        c[u] = wide();
        return placed({c, a, b}, half);
      case 2: {  // along the diagonals
        const std::int64_t s = half * dice_.roll_size((extent + 1) / 2);
        const std::int64_t t = half * dice_.roll_size((extent + 1) / 2);
        a = s * random_in(Vertex(-1), Vertex(1));
        b = t * random_in(Vertex(-1), Vertex(1));
        const Border border{Vertex(0), a, a + b, b};
        return fits(border) ? placed(border, half) : Border(3, Vertex(0));
      }
      default:
        a = {wide(), wide(), wide()};
        b = {wide(), wide(), wide()};
        c = {wide(), wide(), wide()};
        return placed({a, b, c}, half);
    }
  }

  // A lattice polygon in the lattice of two vectors, or, where there is no room for that, in two
  // axes.
  Border many_sided() {
    for (;;) {
      const std::int64_t reach = dice_.roll_size(8);
      const std::vector<FlatVertex> flat =
          lattice_polygon(dice_, static_cast<int>(dice_.roll(3, 16)), reach);
      FlatVertex span(0);
      for (const FlatVertex& v : flat) span = glm::max(span, v);
      const Vertex size = random_size();
      const Vertex step = size / (span.x + span.y);
      Vertex along = random_in(-step, step), across = random_in(-step, step);
      if (cross(along, across) == Vertex(0)) {
        const int axis = static_cast<int>(dice_.roll(0, 2)), u = (axis + 1) % 3, v = (axis + 2) % 3;
        along = across = Vertex(0);
        along[u] = std::max<std::int64_t>(1, size[u] / span.x);
        across[v] = std::max<std::int64_t>(1, size[v] / span.y);
      }
      Border border;
      for (const FlatVertex& v : flat) border.push_back(v.x * along + v.y * across);
      if (fits(border)) return placed(dice_.one_in(2) ? border : turned_over(border));
    }
  }

  Border single_voxel() {
    const std::int64_t half = cube_.one() / 2;
    const Vertex last(cube_.n - 1);
    const Vertex reach(std::max<std::int64_t>(1, half));
    const Vertex centre = cube_.one() * random_in(Vertex(0), last);
    Border border;
    for (int i = 0; i < 3; ++i)
      border.push_back(
          glm::clamp(centre + random_in(-reach, reach), Vertex(cube_.low()), Vertex(cube_.high())));
    if (dice_.one_in(2)) return border;
    // A parallelogram of the same plane that stays within the voxel.
    const Vertex a = (border[1] - border[0]) / std::int64_t{2};
    const Vertex b = (border[2] - border[0]) / std::int64_t{2};
    return {border[0], border[0] + a, border[0] + a + b, border[0] + b};
  }

  Border full_cube() {
    const std::int64_t low = cube_.low(), high = cube_.high();
    const std::int64_t level = dice_.roll(low, high);
    const int axis = static_cast<int>(dice_.roll(0, 2)), u = (axis + 1) % 3, v = (axis + 2) % 3;
    Border border(4, Vertex(low));
    switch (dice_.roll(0, 3)) {
      case 0:  // a wall, or a ramp between two edges that face each other
      case 1: {
        const bool is_ramp = dice_.one_in(2), falls = dice_.one_in(2);
        border[1][u] = border[2][u] = border[2][v] = border[3][v] = high;
        for (Vertex& corner : border) corner[axis] = is_ramp ? corner[falls ? u : v] : level;
        if (is_ramp && dice_.one_in(2))
          for (Vertex& corner : border) corner[axis] = low + high - corner[axis];
        return border;
      }
      case 2: {  // every order of three numbers: a hexagon across the cube
        const Vertex o{low, level, high};
        border = {{o.x, o.y, o.z}, {o.y, o.x, o.z}, {o.z, o.x, o.y},
                  {o.z, o.y, o.x}, {o.y, o.z, o.x}, {o.x, o.z, o.y}};
        const Vertex mirrored = random_in(Vertex(0), Vertex(1));
        for (Vertex& corner : border)
          for (int i = 0; i < 3; ++i)
            if (mirrored[i] != 0) corner[i] = low + high - corner[i];
        return border;
      }
      default:
        border.resize(3);
        for (Vertex& corner : border)
          for (int i = 0; i < 3; ++i)
            corner[i] = dice_.one_in(4) ? dice_.roll(low, high) : dice_.one_in(2) ? low : high;
        return border;
    }
  }

  static Border turned_over(Border border) {
    std::reverse(border.begin(), border.end());
    return border;
  }

  // Vertices that are no corners: on sides, or twice. One facet in eight shrinks to a line.
  void add_superfluous(Border& border) {
    Border result;
    for (std::size_t i = 0; i < border.size(); ++i) {
      result.push_back(border[i]);
      if (dice_.one_in(4)) result.push_back(border[i]);
      const Vertex side = border[(i + 1) % border.size()] - border[i];
      const std::int64_t parts = std::gcd(std::gcd(side.x, side.y), side.z);
      for (std::int64_t part = 1; part < parts && dice_.one_in(2); ++part)
        result.push_back(border[i] + side / parts * part);
    }
    if (dice_.one_in(8))
      for (std::size_t i = 2; i < result.size(); ++i) result[i] = result[i % 2];
    border = result;
  }

  std::vector<Border> duplicates() {
    Border border;
    do {
      switch (dice_.roll(0, 2)) {
        case 0:
          border = triangle();
          break;
        case 1:
          border = half_integer();
          break;
        default:
          border = many_sided();
      }
    } while (doubled_area(border) == Vertex(0));
    Border begun_elsewhere = border;
    std::rotate(begun_elsewhere.begin(), begun_elsewhere.begin() + 1, begun_elsewhere.end());
    Border moved = border;
    const Vertex along = (border[1] - border[0]) / std::int64_t{dice_.roll(1, 3)};
    for (Vertex& v : moved) v += along;
    const bool stays = std::all_of(moved.begin(), moved.end(), [&](const Vertex& v) {
      return v == glm::clamp(v, Vertex(cube_.low()), Vertex(cube_.high()));
    });
    return {border, begun_elsewhere, turned_over(border), stays ? moved : border};
  }

  Cube cube_;
  Dice dice_;
};

}  // namespace

const char* to_string(FacetClass kind) {
  switch (kind) {
    case FacetClass::random:
      return "random";
    case FacetClass::sliver:
      return "sliver";
    case FacetClass::edge_on:
      return "edge-on";
    case FacetClass::half_integer:
      return "half-integer";
    case FacetClass::collinear:
      return "collinear";
    case FacetClass::duplicates:
      return "duplicates";
    case FacetClass::many_sided:
      return "many-sided";
    case FacetClass::single_voxel:
      return "single-voxel";
    case FacetClass::full_cube:
      return "full-cube";
  }
  return "unknown";
}

std::vector<Border> generate_facets(FacetClass kind, const Cube& cube, std::uint64_t seed) {
  return Generator(cube, seed).generate(kind);
}

}  // namespace rc2::facet
