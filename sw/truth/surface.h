// The continuous scene, which no voxel has a part in: Embree 3 on the mesh as it was read.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "sw/truth/triangles.h"

namespace rc2::truth {

/// How far off a surface, in voxels, a ray that starts from it is moved.
constexpr double kLift = 0.002;

/// Places are in voxels. Embree keeps single precision, 2^-15 voxel at 256. Of rays aimed exactly
/// at a side or corner that triangles share, less than one in a thousand slips between them
/// (RTC_SCENE_FLAG_ROBUST, tb/unit/truth_test.cpp).
class Surface {
 public:
  /// Throws Error if Embree cannot be started.
  explicit Surface(const scene::Scene& scene);
  ~Surface();
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const Triangles& triangles() const { return triangles_; }

  /// Whether nothing lies between two points, or on the way to infinity.
  bool sees(const glm::dvec3& from, const glm::dvec3& to) const;
  bool sees_infinity(const glm::dvec3& from, const glm::dvec3& direction) const;

  struct Met {
    double distance;
    std::uint32_t triangle;
    bool is_back;  ///< the ray comes from the triangle's inner side
  };
  using Accepts = std::function<bool(std::uint32_t triangle, bool is_back)>;
  /// The nearest triangle, of those that are accepted, that a ray meets at more than kLift from its
  /// start. `direction` is of unit length.
  std::optional<Met> first_met(const glm::dvec3& from, const glm::dvec3& direction,
                               const Accepts& accepts) const;

  /// How often the surface goes round the point: the triangles that a ray leaves through less those
  /// that it enters through. The median of three rays, because where the mesh is not closed they
  /// may differ.
  int winding(const glm::dvec3& point) const;

  struct Foot {
    glm::dvec3 at;
    std::uint32_t triangle;
  };
  /// The nearest point of the surface. There has to be a triangle.
  Foot nearest(const glm::dvec3& point) const;

 private:
  struct Scene;
  bool is_free(const glm::dvec3& from, const glm::dvec3& way, float end) const;
  int winding_along(const glm::dvec3& point, const glm::dvec3& direction) const;

  Triangles triangles_;
  std::unique_ptr<const Scene> scene_;
};

}  // namespace rc2::truth
