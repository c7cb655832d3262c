// Points of the surface, evenly spread, each given to the voxel that it lies in.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/truth/surface.h"

namespace rc2::truth {

/// A point of the surface, moved off it by kLift voxel along its normal.
struct Sample {
  glm::vec3 at;
  std::uint32_t triangle;
  std::int8_t winding;  ///< Surface::winding there
  bool seen;            ///< by the viewer, who looks along z from z = +infinity
};

/// The sample of a point of a triangle.
Sample make_sample(const Surface& surface, const glm::dvec3& point, std::uint32_t triangle);

class Samples {
 public:
  /// `density` points per unit of area, on every part of the surface within the n-cube and the same
  /// in every run: triangles get their share in turn, what is left over counts for the next; within
  /// a triangle a low-discrepancy sequence places them.
  Samples(const Surface& surface, int n, double density);

  /// Those of a voxel: [first, last).
  struct Range {
    const Sample *first, *last;
    const Sample* begin() const { return first; }
    const Sample* end() const { return last; }
  };
  Range of(const glm::ivec3& voxel) const;

  std::size_t count() const { return samples_.size(); }

 private:
  std::uint32_t key(const glm::ivec3& voxel) const {
    return (static_cast<std::uint32_t>(voxel.z) * n_ + voxel.y) * n_ + voxel.x;
  }

  std::uint32_t n_;
  std::vector<std::uint32_t> keys_;  // of the voxels, ascending
  std::vector<Sample> samples_;      // in the order of keys_
};

}  // namespace rc2::truth
