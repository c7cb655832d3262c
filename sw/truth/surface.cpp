#include "sw/truth/surface.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "sw/truth/embree_scene.h"

namespace rc2::truth {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// In general position, so that a ray hardly ever runs along a side or a plane of a scene.
constexpr std::array<glm::dvec3, 3> kDirections{{{0.312871, 0.547713, 0.776013},
                                                 {-0.823417, 0.391551, 0.410783},
                                                 {0.271093, -0.861377, 0.429511}}};

RTCRay make_ray(const glm::dvec3& from, const glm::dvec3& way, float end) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(from.x);
  ray.org_y = static_cast<float>(from.y);
  ray.org_z = static_cast<float>(from.z);
  ray.dir_x = static_cast<float>(way.x);
  ray.dir_y = static_cast<float>(way.y);
  ray.dir_z = static_cast<float>(way.z);
  ray.tfar = end;
  ray.mask = ~0U;
  return ray;
}

struct Count {
  RTCIntersectContext context;  // Embree hands its address to the filter
  int winding;
};

// Counts a hit and refuses it, so that the ray goes on to the next one.
void count_hit(const RTCFilterFunctionNArguments* arguments) {
  const RTCRay ray = rtcGetRayFromRayN(arguments->ray, 1, 0);
  const RTCHit hit = rtcGetHitFromHitN(arguments->hit, 1, 0);
  const float along = ray.dir_x * hit.Ng_x + ray.dir_y * hit.Ng_y + ray.dir_z * hit.Ng_z;
  reinterpret_cast<Count*>(arguments->context)->winding += along > 0 ? 1 : -1;
  arguments->valid[0] = 0;
}

struct Search {
  RTCIntersectContext context;
  const Surface::Accepts& accepts;
  bool is_back;  // of the last one accepted, which is the nearest
};

void refuse_hit(const RTCFilterFunctionNArguments* arguments) {
  const RTCRay ray = rtcGetRayFromRayN(arguments->ray, 1, 0);
  const RTCHit hit = rtcGetHitFromHitN(arguments->hit, 1, 0);
  auto& search = *reinterpret_cast<Search*>(arguments->context);
  const bool is_back = ray.dir_x * hit.Ng_x + ray.dir_y * hit.Ng_y + ray.dir_z * hit.Ng_z > 0;
  if (search.accepts(hit.primID, is_back))
    search.is_back = is_back;
  else
    arguments->valid[0] = 0;
}

// Ericson, Real-Time Collision Detection, 5.1.5.
glm::dvec3 nearest_in_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                               const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const glm::dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 > d3 ? d1 / (d1 - d3) : 0.0);
  const glm::dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 > d6 ? d2 / (d2 - d6) : 0.0);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return b + (c - b) * (d4 - d3 > 0 || d5 - d6 > 0 ? (d4 - d3) / ((d4 - d3) + (d5 - d6)) : 0.0);
  const double sum = va + vb + vc;
  return sum > 0 ? a + ab * (vb / sum) + ac * (vc / sum) : a;
}

struct NearestFoot {
  const Triangles& triangles;
  glm::dvec3 point;
  Surface::Foot best;
  double square;
};

bool look_at_triangle(RTCPointQueryFunctionArguments* arguments) {
  NearestFoot& search = *static_cast<NearestFoot*>(arguments->userPtr);
  const glm::uvec3& corner = search.triangles.corners[arguments->primID];
  const std::vector<glm::dvec3>& vertices = search.triangles.vertices;
  const glm::dvec3 at =
      nearest_in_triangle(search.point, vertices[corner.x], vertices[corner.y], vertices[corner.z]);
  const glm::dvec3 way = at - search.point;
  const double square = glm::dot(way, way);
  if (square >= search.square) return false;
  search.best = {at, arguments->primID};
  search.square = square;
  arguments->query->radius = static_cast<float>(std::sqrt(square) * 1.0001);
  return true;
}

}  // namespace

struct Surface::Scene : EmbreeScene {
  using EmbreeScene::EmbreeScene;
};

Surface::Surface(const scene::Scene& scene)
    : triangles_(triangles_of(scene)),
      scene_(std::make_unique<Scene>(
          triangles_, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                 RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION))) {}

Surface::~Surface() = default;

bool Surface::is_free(const glm::dvec3& from, const glm::dvec3& way, float end) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = make_ray(from, way, end);
  rtcOccluded1(scene_->scene, &context, &ray);
  return ray.tfar >= 0;
}

bool Surface::sees(const glm::dvec3& from, const glm::dvec3& to) const {
  return is_free(from, to - from, 1);
}

bool Surface::sees_infinity(const glm::dvec3& from, const glm::dvec3& direction) const {
  return is_free(from, direction, kFar);
}

std::optional<Surface::Met> Surface::first_met(const glm::dvec3& from, const glm::dvec3& direction,
                                               const Accepts& accepts) const {
  Search search{{}, accepts, false};
  rtcInitIntersectContext(&search.context);
  search.context.filter = refuse_hit;
  RTCRayHit query{};
  query.ray = make_ray(from, direction, kFar);
  query.ray.tnear = static_cast<float>(kLift);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &search.context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Met{query.ray.tfar, query.hit.primID, search.is_back};
}

int Surface::winding_along(const glm::dvec3& point, const glm::dvec3& direction) const {
  Count count{};
  rtcInitIntersectContext(&count.context);
  count.context.filter = count_hit;
  RTCRayHit query{};
  query.ray = make_ray(point, direction, kFar);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &count.context, &query);
  return count.winding;
}

int Surface::winding(const glm::dvec3& point) const {
  const int a = winding_along(point, kDirections[0]), b = winding_along(point, kDirections[1]);
  if (a == b) return a;
  const int c = winding_along(point, kDirections[2]);
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

Surface::Foot Surface::nearest(const glm::dvec3& point) const {
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query{};
  query.x = static_cast<float>(point.x);
  query.y = static_cast<float>(point.y);
  query.z = static_cast<float>(point.z);
  query.radius = kFar;
  NearestFoot search{triangles_, point, {}, std::numeric_limits<double>::infinity()};
  rtcPointQuery(scene_->scene, &query, &context, look_at_triangle, &search);
  return search.best;
}

}  // namespace rc2::truth
