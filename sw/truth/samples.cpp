#include "sw/truth/samples.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace rc2::truth {
namespace {

// Roberts, The Unreasonable Effectiveness of Quasirandom Sequences (2018): R2, from the real root
// of x^3 = x + 1.
constexpr double kPlastic = 1.32471795724474602596;

glm::dvec3 place_in(const Triangles& triangles, const glm::uvec3& corner, std::size_t index) {
  double u = std::fmod(0.5 + static_cast<double>(index) / kPlastic, 1.0);
  double v = std::fmod(0.5 + static_cast<double>(index) / (kPlastic * kPlastic), 1.0);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const glm::dvec3& a = triangles.vertices[corner.x];
  return a + u * (triangles.vertices[corner.y] - a) + v * (triangles.vertices[corner.z] - a);
}

}  // namespace

Sample make_sample(const Surface& surface, const glm::dvec3& point, std::uint32_t triangle) {
  const glm::dvec3 area = surface.triangles().doubled_area(triangle);
  const double length = glm::length(area);
  const glm::dvec3 at = length > 0 ? point + area * (kLift / length) : point;
  return {at, triangle, static_cast<std::int8_t>(surface.winding(at)),
          area.z > 0 && surface.sees_infinity(at, {0, 0, 1})};
}

Samples::Samples(const Surface& surface, int n, double density)
    : n_(static_cast<std::uint32_t>(n)) {
  const Triangles& triangles = surface.triangles();
  std::vector<Sample> found;
  std::vector<std::uint32_t> keys;
  double due = 0;
  std::size_t index = 0;
  for (std::uint32_t i = 0; i < triangles.corners.size(); ++i) {
    for (due += 0.5 * density * glm::length(triangles.doubled_area(i)); due >= 1; due -= 1) {
      const glm::dvec3 point = place_in(triangles, triangles.corners[i], ++index);
      const glm::ivec3 voxel(glm::floor(point + 0.5));
      if (glm::clamp(voxel, 0, n - 1) != voxel) continue;
      found.push_back(make_sample(surface, point, i));
      keys.push_back(key(voxel));
    }
  }
  std::vector<std::uint32_t> order(found.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  keys_.reserve(order.size());
  samples_.reserve(order.size());
  for (const std::uint32_t i : order) {
    keys_.push_back(keys[i]);
    samples_.push_back(found[i]);
  }
}

Samples::Range Samples::of(const glm::ivec3& voxel) const {
  const auto [first, last] = std::equal_range(keys_.begin(), keys_.end(), key(voxel));
  return {samples_.data() + (first - keys_.begin()), samples_.data() + (last - keys_.begin())};
}

}  // namespace rc2::truth
