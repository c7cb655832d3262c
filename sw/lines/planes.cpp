#include "sw/lines/planes.h"

#include <algorithm>
#include <functional>
#include <glm/common.hpp>
#include <numeric>
#include <tuple>

namespace rc2::lines {
namespace {

int dot(glm::ivec3 a, glm::ivec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

int sum(glm::ivec3 v) { return v.x + v.y + v.z; }

bool is_smaller(const DigitalPlane& a, const DigitalPlane& b) {
  return std::make_tuple(sum(a.normal), a.thickness) < std::make_tuple(sum(b.normal), b.thickness);
}

void meet(Encounter<DigitalPlane>& encounter, const DigitalPlane& plane, bool leaks) {
  ++encounter.surfaces;
  encounter.leaking += static_cast<std::int64_t>(leaks);
  if (leaks && (!encounter.smallest || is_smaller(plane, *encounter.smallest)))
    encounter.smallest = plane;
}

std::size_t promise(const DigitalPlane& plane) {
  std::size_t kind = 0;
  for (std::size_t i = 1; i < kAdjacencies.size(); ++i)
    if (plane.thickness >= separating_thickness(plane.normal, kAdjacencies[i])) kind = i;
  return kind;
}

void add(PlaneSearch& search, const DigitalPlane& plane) {
  if (is_passed(plane, Adjacency::face)) return;
  const std::size_t connected = index_of(local_connectivity(plane)), promised = promise(plane);
  for (std::size_t rays = 0; rays < kAdjacencies.size(); ++rays) {
    const bool leaks = is_passed(plane, kAdjacencies[rays]);
    meet(search.by_connectivity[rays][connected], plane, leaks);
    meet(search.by_separation[rays][promised], plane, leaks);
  }
}

}  // namespace

Adjacency local_connectivity(const DigitalPlane& plane) {
  Adjacency weakest = Adjacency::face;
  for (int value = 0; value < plane.thickness; ++value) {
    const auto has = [&](glm::ivec3 step) {
      const int there = value + dot(plane.normal, step);
      return there >= 0 && there < plane.thickness;
    };
    weakest = std::max(weakest, local_connectivity(neighbourhood({0, 0, 0}, has)));
  }
  return weakest;
}

bool is_passed(const DigitalPlane& plane, Adjacency rays) {
  const auto count = static_cast<std::ptrdiff_t>(rays);
  return std::any_of(kSteps.begin(), kSteps.begin() + count, [&](glm::ivec3 step) {
    return -1 + dot(plane.normal, step) >= plane.thickness;  // -1: the highest value below
  });
}

int separating_thickness(glm::ivec3 normal, Adjacency rays) {
  std::array<int, 3> sizes = {std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return std::accumulate(sizes.begin(), sizes.begin() + 1 + index_of(rays), 0);
}

PlaneSearch search_planes(int largest) {
  PlaneSearch search;
  for (int a = 1; a <= largest; ++a)
    for (int b = 0; b <= a; ++b)
      for (int c = 0; c <= b; ++c)
        if (std::gcd(std::gcd(a, b), c) == 1)
          for (int thickness = 1; thickness <= a + b + c + 1; ++thickness)
            add(search, {{a, b, c}, thickness});
  return search;
}

}  // namespace rc2::lines
