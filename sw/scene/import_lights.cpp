#include "sw/scene/import_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rc2::scene {
namespace {

constexpr float kHalfTurn = 3.14159265F;

// Angle of view. Where Assimp finds none that it knows (Collada's yfov), it hands on its default, a
// quarter turn's half, as if that were degrees; nobody looks through less than a degree.
float view_angle(float angle) {
  constexpr float kDegree = kHalfTurn / 180;
  return angle < kDegree ? kHalfTurn / 4 : angle;
}

// Assimp ties lights and cameras to nodes by name only.
glm::dmat4 placement(const std::vector<PlacedNode>& nodes, const aiString& name) {
  for (const PlacedNode& placed : nodes)
    if (placed.node->mName == name) return placed.to_scene;
  return nodes.front().to_scene;
}

glm::dvec3 point(const glm::dmat4& to_scene, const aiVector3D& p) {
  return to_scene * glm::dvec4(p.x, p.y, p.z, 1.0);
}

glm::dvec3 direction(const glm::dmat4& to_scene, const aiVector3D& d) {
  return glm::normalize(glm::dvec3(to_scene * glm::dvec4(d.x, d.y, d.z, 0.0)));
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

void import_lights(const aiScene& source, const std::vector<PlacedNode>& nodes, Scene& scene) {
  float brightest = 1.0F;
  for (unsigned i = 0; i < source.mNumLights; ++i) {
    const aiLight& light = *source.mLights[i];
    const bool has_place = light.mType == aiLightSource_POINT ||
                           light.mType == aiLightSource_SPOT || light.mType == aiLightSource_AREA;
    const glm::vec3 colour(light.mColorDiffuse.r, light.mColorDiffuse.g, light.mColorDiffuse.b);
    const glm::dvec3 position = point(placement(nodes, light.mName), light.mPosition);
    const float peak = std::max({colour.r, colour.g, colour.b});
    if (!has_place || !is_finite(position) || !is_finite(colour) || peak <= 0.0F) {
      ++scene.ignored_lights;
      continue;
    }
    brightest = std::max(brightest, peak);
    scene.lights.push_back({position, colour});
  }
  for (Light& light : scene.lights) light.colour /= brightest;
}

void import_camera(const aiScene& source, const std::vector<PlacedNode>& nodes, Scene& scene) {
  if (source.mNumCameras == 0) return;
  const aiCamera& camera = *source.mCameras[0];
  const glm::dmat4 to_scene = placement(nodes, camera.mName);
  const Camera result{point(to_scene, camera.mPosition), direction(to_scene, camera.mLookAt),
                      direction(to_scene, camera.mUp), view_angle(camera.mHorizontalFOV)};
  if (is_finite(result.position) && is_finite(result.direction) && is_finite(result.up) &&
      result.angle < kHalfTurn)
    scene.camera = result;
}

}  // namespace rc2::scene
