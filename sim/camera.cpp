#include "sim/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "sw/base/error.h"

namespace rc2 {
namespace {

// How far along the ray the cube is entered, unless it is missed.
std::optional<double> entry(const Sight& sight, double low, double high) {
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double from = sight.from[axis], speed = sight.direction[axis];
    if (speed == 0) {
      if (from < low || from > high) return std::nullopt;
      continue;
    }
    const double a = (low - from) / speed, b = (high - from) / speed;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (first > last) return std::nullopt;
  return first;
}

}  // namespace

std::vector<Sight> camera_sights(const scene::Camera& camera, int n) {
  const glm::dvec3 forward = glm::normalize(camera.direction);
  const glm::dvec3 across = glm::cross(forward, camera.up);
  if (!(glm::length(across) > 1e-6 * glm::length(camera.up)))
    throw Error(
        "the scene's camera looks along its own up, so the picture has no upper side; mend the "
        "file, or use --view front");
  const glm::dvec3 right = glm::normalize(across), up = glm::cross(right, forward);
  const double half = std::tan(camera.angle / 2);
  std::vector<Sight> sights;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const double u = half * ((2 * x + 1.0) / n - 1), v = half * ((2 * y + 1.0) / n - 1);
      sights.push_back({camera.position, glm::normalize(forward + u * right + v * up)});
    }
  }
  return sights;
}

std::vector<Sight> front_sights(int n) {
  std::vector<Sight> sights;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) sights.push_back({{x, y, n - 0.5}, {0, 0, -1}});
  return sights;
}

std::vector<RayStart> ray_starts(const std::vector<Sight>& sights, int n) {
  constexpr double kOne = rays::kPlaceOne;
  const double low = -0.5, high = n - 0.5 - 1 / kOne;
  std::vector<RayStart> starts;
  for (const Sight& sight : sights) {
    const std::optional<double> way = entry(sight, low, high);
    if (!way) {
      starts.push_back({glm::ivec3(0), glm::ivec3(0)});
      continue;
    }
    const glm::dvec3 place = glm::clamp(sight.from + *way * sight.direction, low, high);
    const double one = 1 << rays::direction_fraction(n);
    starts.push_back({glm::ivec3(glm::floor(place * kOne + 0.5)),
                      glm::ivec3(glm::floor(sight.direction * one + 0.5))});
  }
  return starts;
}

}  // namespace rc2
