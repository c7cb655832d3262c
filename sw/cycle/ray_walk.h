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
  /// What arithmetic takes of them (ray_timing.h).
  int meet_cycles = 0, bend_cycles = 0;
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
  /// go to the neighbour along axis().
  void probe(const Columns& columns, const RayJob& job, RayCounts& counts);

  bool is_probed() const { return is_probed_; }
  /// Voxels that are read: those on its way that are armoured, or not on the side of matter that
  /// the ray is on. Up to the one where it ends, if it does.
  int reads() const { return reads_; }
  /// There are more such beyond the one where it ends.
  bool has_more() const { return has_more_; }
  const std::optional<RayEnd>& end() const { return end_; }
  int axis() const { return axis_; }
  int step() const { return ray_.direction[axis_] < 0 ? -1 : 1; }

  /// Whether another ray starts in the column that this one is in.
  bool is_here(const rays::Ray& ray) const {
    return glm::ivec2(rays::voxel_of(ray.origin)) == glm::ivec2(at_);
  }

  /// The cell is done with it: it may go on from that cycle on.
  void send(std::int64_t ready_at) { ready_at_ = ready_at; }
  bool is_sent() const { return ready_at_ != kNever; }
  bool may_go(std::int64_t cycle) const { return is_sent() && cycle >= ready_at_; }

  /// The ray has come to the neighbour: two additions.
  void advance();

  /// Cycles since the pixel's first ray began, had nothing ever waited.
  std::int64_t age = 0;

 private:
  static constexpr std::int64_t kNever = -1;

  struct Touched {
    glm::ivec3 voxel;
    std::uint32_t facet;
    rays::Face face;
  };

  // Of the armoured voxel that the ray is in.
  void visit_armour(const Columns& columns, const RayJob& job, int axis, RayCounts& counts);
  void hit(const RayJob& job, const glm::ivec3& here, bool is_rescued);
  bool is_worth_a_look(const Columns& columns, std::size_t column, int z) const;
  void leave_cube(const RayJob& job);

  rays::Ray ray_;
  int n_;
  rays::Launch state_;
  glm::ivec3 at_;
  int axis_ = 0;
  bool is_probed_ = false;
  bool has_more_ = false;
  int reads_ = 0;
  std::int64_t ready_at_ = kNever;
  bool in_room_ = false;
  std::optional<Touched> touched_;
  std::optional<RayEnd> end_;
};

}  // namespace rc2::cycle
