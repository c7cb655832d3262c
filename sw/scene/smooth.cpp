#include "sw/scene/smooth.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <tuple>

namespace rc2::scene {
namespace {

constexpr double kCosineOfCrease = 0.70710678118654752440;
constexpr double kNowhere = 1e-9;

// Newell's sum: of any polygon, planar or not; as long as twice its area.
glm::dvec3 newell(const Scene& scene, std::size_t first, std::size_t end) {
  glm::dvec3 sum(0);
  for (std::size_t i = first; i < end; ++i)
    sum += glm::cross(scene.vertices[i], scene.vertices[i + 1 < end ? i + 1 : first]);
  return sum;
}

glm::dvec3 unit(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > kNowhere ? v / length : otherwise;
}

struct InAnyOrder {
  bool operator()(const glm::dvec3& a, const glm::dvec3& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

// tan(angle / 2) of the angle at which a side is seen whose ends are a and b away; none from a
// place on the side or beyond it.
std::optional<double> half_tangent(const glm::dvec3& a, const glm::dvec3& b,
                                   const glm::dvec3& normal) {
  const double below = glm::length(a) * glm::length(b) + glm::dot(a, b);
  const double across = glm::dot(glm::cross(a, b), normal);
  if (below < kNowhere || across < -kNowhere) return std::nullopt;
  return across / below;
}

// How far along a side, whose ends are a and b away, the nearest point of it is: 0 to 1.
double along(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 side = b - a;
  const double square = glm::dot(side, side);
  return square > 0 ? std::clamp(-glm::dot(a, side) / square, 0.0, 1.0) : 0;
}

}  // namespace

SmoothNormals::SmoothNormals(const Scene& scene) : scene_(scene), corners_(scene.vertices.size()) {
  std::map<glm::dvec3, std::vector<std::size_t>, InAnyOrder> meeting;
  for (std::size_t polygon = 0; polygon < scene.polygon_count(); ++polygon) {
    const std::size_t first = scene.first[polygon], end = scene.first[polygon + 1];
    flat_.push_back(unit(newell(scene, first, end), glm::dvec3(0)));
    for (std::size_t i = first; i < end; ++i) meeting[scene.vertices[i]].push_back(polygon);
  }
  for (std::size_t polygon = 0; polygon < scene.polygon_count(); ++polygon) {
    const glm::dvec3& own = flat_[polygon];
    for (std::size_t i = scene.first[polygon]; i < scene.first[polygon + 1]; ++i) {
      corners_[i] = scene.normals[i];
      if (glm::dot(corners_[i], own) > 0) continue;
      glm::dvec3 sum(0);
      for (const std::size_t other : meeting.at(scene.vertices[i]))
        if (glm::dot(flat_[other], own) >= kCosineOfCrease) sum += flat_[other];
      corners_[i] = unit(sum, own);
    }
  }
}

// Mean value coordinates (Floater 2003), which need no triangles.
glm::dvec3 SmoothNormals::at(std::uint32_t polygon, const glm::dvec3& place) const {
  const glm::dvec3& own = flat_[polygon];
  const std::size_t first = scene_.first[polygon], end = scene_.first[polygon + 1];
  const glm::dvec3 foot = place - glm::dot(place - scene_.vertices[first], own) * own;
  const auto way = [&](std::size_t corner) { return scene_.vertices[corner] - foot; };
  glm::dvec3 sum(0);
  for (std::size_t i = first; i < end; ++i) {
    const std::size_t after = i + 1 < end ? i + 1 : first;
    const double here = glm::length(way(i)), there = glm::length(way(after));
    if (here < kNowhere) return corners_[i];
    const auto weight = half_tangent(way(i), way(after), own);
    if (!weight)
      return unit(glm::mix(corners_[i], corners_[after], along(way(i), way(after))), own);
    sum += *weight * (corners_[i] / here + corners_[after] / std::max(there, kNowhere));
  }
  return unit(sum, own);
}

}  // namespace rc2::scene
