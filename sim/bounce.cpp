#include "sim/bounce.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "sim/camera.h"
#include "sim/render_job.h"
#include "sw/scene/random.h"

namespace rc2 {
namespace {

constexpr double kGross = 2;  // voxels
constexpr double kCosineOfDegree = 0.99984769515639123916;

glm::dvec3 random_direction(const glm::dvec3& normal, scene::Random& random) {
  for (;;) {
    const glm::dvec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    const double square = glm::dot(v, v);
    if (square > 1 || square < 0.01) continue;
    return glm::normalize(glm::dot(v, normal) < 0 ? -v : v);
  }
}

void judge(const truth::Whitted& truth, const Sight& sight, const RayHit& first,
           const RayHit* second, Bounce& sum) {
  ++sum.rays;
  const auto want = truth.first_hit(sight.from, sight.direction, false);
  const bool escaped = first.facet == RayHit::kNoFacet;
  if (escaped && !want) {
    ++sum.straight;
    return;
  }
  const glm::dvec3 at = glm::dvec3(first.point) / double{rays::kPlaceOne};
  const double off = escaped || !want ? kGross + 1 : glm::distance(at, want->at);
  if (off > kGross) {
    ++sum.gross;
    const auto way = [&](const glm::dvec3& place) { return glm::distance(place, sight.from); };
    if (!escaped && (!want || way(at) < way(want->at))) ++sum.early;
    return;
  }
  sum.distance += off;
  const glm::dvec3 reflected = glm::reflect(sight.direction, want->normal);
  const glm::dvec3 have = glm::normalize(glm::dvec3(second->ray.direction));
  const double cosine = std::min(1.0, glm::dot(reflected, have));
  sum.degrees += glm::degrees(std::acos(cosine));
  if (cosine >= kCosineOfDegree) ++sum.straight;
}

// Every facet a mirror: the ray that a hit sends out tells the normal that the machine has.
void follow(const truth::Whitted& truth, const std::vector<Sight>& sights,
            std::vector<rays::Facet> optics, const Trace& trace, int n, Bounce& sum) {
  const auto pixels = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  std::vector<RayStart> starts = ray_starts(sights, n);
  starts.resize(pixels);
  make_mirrors(optics);
  const RayResult result = trace({{1, 1}, &optics, &starts});
  std::vector<const RayHit*> first(pixels), second(pixels);
  for (const RayHit& hit : result.hits) {
    const auto pixel = static_cast<std::size_t>(hit.ray.home.y) * static_cast<std::size_t>(n) +
                       static_cast<std::size_t>(hit.ray.home.x);
    (hit.ray.node == 1 ? first : second)[pixel] = &hit;
  }
  for (std::size_t i = 0; i < sights.size(); ++i)
    if (first[i] != nullptr) judge(truth, sights[i], *first[i], second[i], sum);
}

}  // namespace

Bounce measure_bounce(const truth::Whitted& truth, const scene::Scene& scene,
                      const std::vector<rays::Facet>& optics, const Trace& trace, int n) {
  scene::Random random(1);
  std::vector<Sight> mirrored, scattered;
  for (Sight sight : front_sights(n)) {
    // Off the middle of the pixel: there are edges of generated scenes.
    sight.from.x += random.between(-0.5, 0.5);
    sight.from.y += random.between(-0.5, 0.5);
    const auto hit = truth.first_hit(sight.from, sight.direction, false);
    if (!hit) continue;
    if (scene.materials[scene.material[hit->polygon]].mirror > 0)
      mirrored.push_back({hit->at, glm::reflect(sight.direction, hit->normal)});
    scattered.push_back({hit->at, random_direction(hit->normal, random)});
  }
  Bounce bounce;
  follow(truth, mirrored, optics, trace, n, bounce);
  follow(truth, scattered, optics, trace, n, bounce);
  return bounce;
}

}  // namespace rc2
