#include "sw/truth/embree_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "sw/base/error.h"

namespace rc2::truth {

EmbreeScene::EmbreeScene(const Triangles& triangles, RTCSceneFlags flags)
    : device(rtcNewDevice("threads=1")) {
  if (device == nullptr)
    throw Error(fmt::format("Embree does not start (error {}); install libembree3-3 anew",
                            static_cast<int>(rtcGetDeviceError(nullptr))));
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, flags);
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                              triangles.vertices.size()));
  std::copy(triangles.vertices.begin(), triangles.vertices.end(), vertices);
  auto* corners = static_cast<glm::uvec3*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                              triangles.corners.size()));
  std::copy(triangles.corners.begin(), triangles.corners.end(), corners);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene);
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

}  // namespace rc2::truth
