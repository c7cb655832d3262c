#include "sw/truth/whitted.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sw/scene/shade.h"

namespace rc2::truth {

Whitted::Whitted(const scene::Scene& scene, std::vector<rays::Body> bodies, int n,
                 const scene::SmoothNormals* smooth)
    : scene_(scene), bodies_(std::move(bodies)), n_(n), smooth_(smooth), surface_(scene) {}

bool Whitted::is_glass(std::uint32_t polygon) const {
  return bodies_[polygon] == rays::Body::solid &&
         scene_.materials[scene_.material[polygon]].transparency > 0;
}

std::optional<Whitted::Hit> Whitted::first_hit(const glm::dvec3& from, const glm::dvec3& direction,
                                               bool inside) const {
  const Triangles& triangles = surface_.triangles();
  const auto met = surface_.first_met(from, direction, [&](std::uint32_t triangle, bool is_back) {
    const std::uint32_t polygon = triangles.polygon[triangle];
    if (bodies_[polygon] == rays::Body::sheet) return true;
    return is_back == (inside && is_glass(polygon));
  });
  if (!met) return std::nullopt;
  const glm::dvec3 outward = glm::normalize(triangles.doubled_area(met->triangle));
  const glm::dvec3& corner = triangles.vertices[triangles.corners[met->triangle].x];
  const double distance = glm::dot(outward, corner - from) / glm::dot(outward, direction);
  return Hit{from + distance * direction, met->is_back ? -outward : outward,
             triangles.polygon[met->triangle], met->is_back};
}

glm::vec3 Whitted::shade(const Hit& hit, const glm::dvec3& direction,
                         const std::vector<Lamp>& lamps) const {
  const scene::Material& material = scene_.materials[scene_.material[hit.polygon]];
  glm::dvec3 normal = hit.normal;
  if (smooth_ != nullptr)
    normal = hit.is_back ? -smooth_->at(hit.polygon, hit.at) : smooth_->at(hit.polygon, hit.at);
  glm::vec3 colour = scene::own_light(material);
  for (const Lamp& lamp : lamps) {
    const glm::dvec3 way = lamp.at - hit.at;
    const double distance = glm::length(way);
    if (distance == 0 || glm::dot(way, normal) <= 0) continue;
    if (lamp.casts_shadows && !surface_.sees(hit.at + kLift * hit.normal, lamp.at)) continue;
    colour += scene::thrown_back(material, normal, -direction, way / distance) *
              scene::faded(lamp.colour, static_cast<float>(distance), n_);
  }
  return colour;
}

glm::vec3 Whitted::colour(const glm::dvec3& from, const glm::dvec3& direction,
                          const std::vector<Lamp>& lamps, int depth, bool inside) const {
  const std::optional<Hit> hit = first_hit(from, direction, inside);
  if (!hit) return scene::kBackground;
  const scene::Material& material = scene_.materials[scene_.material[hit->polygon]];
  const bool glass = is_glass(hit->polygon);
  const bool is_way = glass && hit->is_back;
  glm::vec3 sum = is_way ? glm::vec3(0) : shade(*hit, direction, lamps);
  if (depth == 0) return sum;
  const float clear = std::min(material.transparency, 1 - material.mirror);
  float mirror = material.mirror;
  if (clear > 0) {
    const double index = material.refractive_index;
    const auto onwards =
        glass ? refract(direction, hit->normal, hit->is_back ? index : 1 / index) : direction;
    if (onwards)
      sum += clear * colour(hit->at, *onwards, lamps, depth - 1, inside != glass);
    else
      mirror += clear;
  }
  if (mirror > 0)
    sum += mirror * colour(hit->at, glm::reflect(direction, hit->normal), lamps, depth - 1, inside);
  return sum;
}

std::optional<glm::dvec3> refract(const glm::dvec3& direction, const glm::dvec3& normal,
                                  double ratio) {
  const double cosine = -glm::dot(direction, normal);
  const double square = 1 - ratio * ratio * (1 - cosine * cosine);
  if (square < 0) return std::nullopt;
  return glm::normalize(ratio * direction + (ratio * cosine - std::sqrt(square)) * normal);
}

}  // namespace rc2::truth
