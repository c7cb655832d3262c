#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fmt/format.h"
#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/scene/generate_parts.h"
#include "sw/scene/random.h"
#include "sw/scene/shapes.h"

namespace rc2::scene {
namespace {

constexpr int kColours = 6;

void add_colours(Scene& scene) {
  const glm::vec3 colours[kColours] = {{0.8F, 0.3F, 0.2F}, {0.8F, 0.7F, 0.2F}, {0.3F, 0.7F, 0.3F},
                                       {0.2F, 0.6F, 0.7F}, {0.3F, 0.3F, 0.8F}, {0.7F, 0.3F, 0.7F}};
  for (const glm::vec3& colour : colours) {
    Material material;
    material.diffuse = colour;
    scene.materials.push_back(material);
  }
}

// A place for something that reaches `reach` to both sides, inside voxel centres 1 .. n-2.
glm::dvec3 random_place(Random& random, int n, const glm::dvec3& reach) {
  const glm::dvec3 low = 1.0 + reach, high = glm::dvec3(n - 2.0) - reach;
  const double x = random.between(low.x, high.x), y = random.between(low.y, high.y),
               z = random.between(low.z, high.z);
  return {x, y, z};
}

}  // namespace

double armoured_voxels(const Scene& scene, std::size_t polygon) {
  const glm::dvec3* corner = &scene.vertices[scene.first[polygon]];
  const std::uint32_t count = scene.first[polygon + 1] - scene.first[polygon];
  glm::dvec3 doubled_area(0.0);
  for (std::uint32_t i = 2; i < count; ++i)
    doubled_area += glm::cross(corner[i - 1] - corner[0], corner[i] - corner[0]);
  return 0.5 * (std::abs(doubled_area.x) + std::abs(doubled_area.y) + std::abs(doubled_area.z));
}

void generate_shells(Scene& scene, int n, double percent, std::uint64_t seed) {
  const double room = std::pow(std::max(0, n - 2), 3);
  const double share = percent / 100.0 * std::pow(n, 3) / std::max(1.0, room);
  if (n < 4 || share > 0.9)
    throw Error(fmt::format(
        "{}: shells leave the outer voxels of the cube free, so {} % of {} "
        "voxels a side is too much; choose at most {:.0f} %",
        scene.name, percent, n, n < 4 ? 0.0 : std::floor(90.0 * room / std::pow(n, 3))));
  add_colours(scene);
  Random random(seed);
  // Shells placed without regard to each other that would cover a share of s when side by side
  // cover 1 - exp(-s) of the space.
  const double wanted = -room * std::log(1.0 - share);
  // Longer edges in large cubes keep the whole scene near 20 000 facets.
  const double edge = std::max(kEdge, std::sqrt(wanted / 13000.0));
  const double largest = 0.45 * (n - 3);  // reach of what fits between voxel centres 1 and n-2
  // A sphere covers 6 pi R^2 voxels; no object may be more than about an eighth of the scene.
  const double high = std::min(0.5 * largest, std::max(1.5, std::sqrt(wanted / 150.0)));
  const double low = std::min(high, std::max(1.5, n / 16.0));
  std::size_t counted = 0;
  for (double placed = 0.0; placed < wanted;) {
    const auto colour = static_cast<std::uint32_t>(random.below(kColours));
    const double radius = random.between(low, high);
    if (random.below(2) == 0) {
      add_sphere(scene, random_place(random, n, glm::dvec3(radius)), radius, edge, colour);
    } else {
      Box box;
      for (int axis = 0; axis < 3; ++axis) box.half_size[axis] = radius * random.between(0.3, 0.9);
      if (random.below(3) != 0) box.axes = random_rotation(random);
      glm::dvec3 reach(0.0);
      for (int axis = 0; axis < 3; ++axis) reach += glm::abs(box.axes[axis]) * box.half_size[axis];
      // A rotated box may be longer than its radius; shrunk, it fits any cube.
      const double excess = std::max({reach.x, reach.y, reach.z}) / largest;
      if (excess > 1.0) {
        box.half_size /= excess;
        reach /= excess;
      }
      box.centre = random_place(random, n, reach);
      add_box(scene, box, colour);
    }
    for (; counted < scene.polygon_count(); ++counted) placed += armoured_voxels(scene, counted);
  }
}

void generate_dust(Scene& scene, int n, double percent, std::uint64_t seed) {
  const auto side = static_cast<std::size_t>(n);
  const auto count = static_cast<std::int64_t>(std::floor(percent / 100.0 * std::pow(n, 3) + 0.5));
  if (count > kMaxFacets)
    throw Error(
        fmt::format("{}: {} voxels need as many facets and the machine numbers at most {}; "
                    "choose fewer per cent",
                    scene.name, count, kMaxFacets));
  add_colours(scene);
  Random random(seed);
  std::vector<bool> taken(side * side * side);
  const auto index = [&](const glm::ivec3& p) {
    return (static_cast<std::size_t>(p.z) * side + p.y) * side + p.x;
  };
  const auto has_neighbour = [&](const glm::ivec3& p) {
    for (int z = std::max(0, p.z - 1); z <= std::min(n - 1, p.z + 1); ++z)
      for (int y = std::max(0, p.y - 1); y <= std::min(n - 1, p.y + 1); ++y)
        for (int x = std::max(0, p.x - 1); x <= std::min(n - 1, p.x + 1); ++x)
          if (taken[index({x, y, z})]) return true;
    return false;
  };
  constexpr int kPatience = 1000;  // tries before neighbours are allowed
  int failures = 0;
  for (std::int64_t placed = 0; placed < count;) {
    const int x = random.below(n), y = random.below(n), z = random.below(n);
    const glm::ivec3 p(x, y, z);
    if (taken[index(p)] || (failures < kPatience && has_neighbour(p))) {
      ++failures;
      continue;
    }
    if (failures < kPatience) failures = 0;
    taken[index(p)] = true;
    ++placed;
    // Its grown box, half open, holds this voxel only (closed, as for supercover, three more).
    const glm::dvec3 corner(p);
    scene.add({corner, corner + glm::dvec3(0.5, 0, 0), corner + glm::dvec3(0, 0.5, 0)},
              static_cast<std::uint32_t>(random.below(kColours)));
  }
}

}  // namespace rc2::scene
