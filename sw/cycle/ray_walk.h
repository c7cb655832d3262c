// A ray on its way: what it carries from cell to cell, and what one cell does with it.
#pragma once

#include <optional>

#include "sw/cycle/column.h"
#include "sw/machine/ray_job.h"
#include "sw/rays/face.h"
#include "sw/rays/launch.h"

namespace rc2::cycle {

/// How a ray has ended.
struct RayEnd {
  RayHit hit;
  rays::Split split;
  bool is_rescued = false;
  int cycles = 0;  ///< of the arithmetic that takes
};

class RayWalk {
 public:
  /// A ray at its start.
  RayWalk(const rays::Ray& ray, int n);

  /// Which way the ray goes, bit 0: west, bit 1: south. It never changes.
  unsigned quadrant() const {
    return (ray_.direction.x < 0 ? 1U : 0U) | (ray_.direction.y < 0 ? 2U : 0U);
  }

  /// Looks into the column that the ray is in, once. Then either end() is there, or the ray is to
  /// go to the neighbour along axis(). Returns how many voxels are read: those on its way that are
  /// armoured, or not on the side of matter that the ray is on.
  int probe(const Columns& columns, const RayJob& job, RayCounts& counts);

  bool is_probed() const { return is_probed_; }
  /// Out of the column the ray has left the cube, rescued or not.
  bool is_beyond() const { return is_beyond_; }
  const std::optional<RayEnd>& end() const { return end_; }
  int axis() const { return axis_; }
  int step() const { return ray_.direction[axis_] < 0 ? -1 : 1; }

  /// The ray has come to the neighbour: two additions.
  void advance();

  /// Cycles since the pixel's first ray began, had nothing ever waited.
  std::int64_t age = 0;

  /// The first cycle in which it may go on.
  std::int64_t ready_at = 0;

 private:
  struct Touched {
    glm::ivec3 voxel;
    std::uint32_t facet;
    rays::Face face;
  };

  // Of the armoured voxel that the ray is in. True if it ends here.
  bool visit_armour(const Columns& columns, const RayJob& job, int axis, RayCounts& counts);
  void hit(const RayJob& job, const glm::ivec3& here, bool is_rescued);
  int arithmetic_cycles(const rays::Facet& facet, const rays::Face& face, bool is_mirrored) const;
  void leave_cube(const RayJob& job);

  rays::Ray ray_;
  int n_;
  rays::Launch state_;
  glm::ivec3 at_;
  int axis_ = 0;
  bool is_probed_ = false;
  bool is_beyond_ = false;
  bool in_room_ = false;
  std::optional<Touched> touched_;
  std::optional<RayEnd> end_;
};

}  // namespace rc2::cycle
