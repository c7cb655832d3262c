#include "sw/peers/shadow_rays.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>

#include "sw/truth/embree_scene.h"

namespace rc2::peers {

struct ShadowRays::Scene : truth::EmbreeScene {
  using EmbreeScene::EmbreeScene;
};

ShadowRays::ShadowRays(const truth::Triangles& triangles)
    : scene_(std::make_unique<Scene>(triangles, RTC_SCENE_FLAG_NONE)) {}

ShadowRays::~ShadowRays() = default;

std::vector<bool> ShadowRays::one_by_one(const std::vector<glm::vec3>& places,
                                         const glm::vec3& light) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  std::vector<bool> lit;
  lit.reserve(places.size());
  for (const glm::vec3& place : places) {
    const glm::vec3 way = light - place;
    RTCRay ray{};
    ray.org_x = place.x;
    ray.org_y = place.y;
    ray.org_z = place.z;
    ray.dir_x = way.x;
    ray.dir_y = way.y;
    ray.dir_z = way.z;
    ray.tfar = 1;
    ray.mask = ~0U;
    rtcOccluded1(scene_->scene, &context, &ray);
    lit.push_back(ray.tfar >= 0);
  }
  return lit;
}

std::vector<bool> ShadowRays::by_eight(const std::vector<glm::vec3>& places,
                                       const glm::vec3& light) const {
  constexpr std::size_t kWidth = 8;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  std::vector<bool> lit;
  lit.reserve(places.size());
  for (std::size_t first = 0; first < places.size(); first += kWidth) {
    const std::size_t count = std::min(kWidth, places.size() - first);
    alignas(32) std::array<int, kWidth> valid{};
    RTCRay8 rays{};
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec3 &place = places[first + i], way = light - place;
      valid[i] = -1;
      rays.org_x[i] = place.x;
      rays.org_y[i] = place.y;
      rays.org_z[i] = place.z;
      rays.dir_x[i] = way.x;
      rays.dir_y[i] = way.y;
      rays.dir_z[i] = way.z;
      rays.tfar[i] = 1;
      rays.mask[i] = ~0U;
    }
    rtcOccluded8(valid.data(), scene_->scene, &context, &rays);
    for (std::size_t i = 0; i < count; ++i) lit.push_back(rays.tfar[i] >= 0);
  }
  return lit;
}

}  // namespace rc2::peers
