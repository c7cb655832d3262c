#include "sim/bounce.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "sim/camera.h"
#include "sim/render_job.h"
#include "sw/scene/random.h"

namespace rc2 {
namespace {

constexpr double kGross = 2;     // voxels
constexpr double kBeside = 0.5;  // likewise
constexpr double kCosineOfDegree = 0.99984769515639123916;

glm::dvec3 random_direction(const glm::dvec3& normal, scene::Random& random) {
  for (;;) {
    const glm::dvec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    const double square = glm::dot(v, v);
    if (square > 1 || square < 0.01) continue;
    return glm::normalize(glm::dot(v, normal) < 0 ? -v : v);
  }
}

using At = std::optional<glm::dvec3>;  // none: it leaves the cube

bool is_gross(const At& have, const At& want) {
  return have.has_value() != want.has_value() || (have && glm::distance(*have, *want) > kGross);
}

At end_of(const std::optional<truth::Whitted::Hit>& hit) { return hit ? At(hit->at) : At(); }

// Whether the ray passes an edge so closely that a true one beside it, which ends on another
// polygon or on none, ends where this one does.
bool is_at_edge(const truth::Whitted& truth, const Sight& sight, const At& have,
                const std::optional<truth::Whitted::Hit>& want) {
  constexpr int kRings = 4, kSpokes = 16;
  const glm::dvec3 way = glm::normalize(sight.direction);
  const glm::dvec3 axis =
      std::abs(way.x) < std::abs(way.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(way, axis)), v = glm::cross(way, u);
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double turn = glm::radians(360.0 * spoke / kSpokes);
      const glm::dvec3 aside = kBeside * ring / kRings * (std::cos(turn) * u + std::sin(turn) * v);
      const auto beside = truth.first_hit(sight.from + aside, way, false);
      if (beside && want && beside->polygon == want->polygon) continue;
      if (!is_gross(have, end_of(beside))) return true;
    }
  }
  return false;
}

void judge(const truth::Whitted& truth, const Sight& sight, const RayHit& first,
           const RayHit* second, Bounce& sum) {
  ++sum.rays;
  const auto want = truth.first_hit(sight.from, sight.direction, false);
  const At have = first.facet == RayHit::kNoFacet
                      ? At()
                      : At(glm::dvec3(first.point) / double{rays::kPlaceOne});
  if (is_gross(have, end_of(want))) {
    ++sum.gross;
    const auto way = [&](const glm::dvec3& place) { return glm::distance(place, sight.from); };
    if (have && (!want || way(*have) < way(want->at))) ++sum.early;
    if (is_at_edge(truth, sight, have, want)) ++sum.edges;
    return;
  }
  if (!want) {
    ++sum.straight;
    return;
  }
  sum.distance += glm::distance(*have, want->at);
  const glm::dvec3 reflected = glm::reflect(sight.direction, want->normal);
  const glm::dvec3 turned = glm::normalize(glm::dvec3(second->ray.direction));
  const double cosine = std::min(1.0, glm::dot(reflected, turned));
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
