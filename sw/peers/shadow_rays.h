// What one would use first: a ray tracer, one shadow ray for each place that may be lit.
#pragma once

#include <memory>
#include <vector>

#include "sw/truth/triangles.h"

namespace rc2::peers {

/// Embree 3 with its defaults, one thread: not the robust scene that sw/truth asks for the truth.
class ShadowRays {
 public:
  /// Builds the tree. Throws Error if Embree cannot be started.
  explicit ShadowRays(const truth::Triangles& triangles);
  ~ShadowRays();
  ShadowRays(const ShadowRays&) = delete;
  ShadowRays& operator=(const ShadowRays&) = delete;

  /// Of each place whether nothing lies between it and the light: rays one by one (rtcOccluded1),
  /// or eight at a time (rtcOccluded8).
  std::vector<bool> one_by_one(const std::vector<glm::vec3>& places, const glm::vec3& light) const;
  std::vector<bool> by_eight(const std::vector<glm::vec3>& places, const glm::vec3& light) const;

 private:
  struct Scene;
  std::unique_ptr<const Scene> scene_;
};

}  // namespace rc2::peers
