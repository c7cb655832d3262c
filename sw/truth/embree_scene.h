#pragma once

#include <embree3/rtcore.h>

#include "sw/truth/triangles.h"

namespace rc2::truth {

/// Triangles as Embree wants them, one thread.
struct EmbreeScene {
  /// Throws Error if Embree cannot be started.
  EmbreeScene(const Triangles& triangles, RTCSceneFlags flags);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCDevice device;
  RTCScene scene;
};

}  // namespace rc2::truth
