#pragma once

#include <cstdint>
#include <cstdlib>

#include "sw/lines/segment.h"

namespace rc2::lines {

/// Loceff's line in a plane (thesis 2.3.4): not voxel after voxel but run after run. A run is the
/// pixels of one height; all but the first and the last are as long as the whole part of the
/// inverse slope, or one longer, and one comparison tells which.
class LoceffRuns {
 public:
  /// A line over `length` steps that ends `rise` higher (or lower), |rise| <= length.
  LoceffRuns(std::int64_t length, std::int64_t rise) {
    const std::int64_t height = std::abs(rise);
    if (height == 0) {  // one run; the printed N = ENT(DX/DY) has no value
      first_ = length + 1;
      return;
    }
    // Nearest pixels, ties downwards: a rising line leaves its first run after the tie, a falling
    // one before it. The printed line begins with a whole run instead of about half of one, which
    // puts pixels off the segment by nearly one, and it omits the last point.
    const std::int64_t before_tie = rise < 0 ? 1 : 0;
    first_ = (length - before_tie) / (2 * height) + 1;
    run_ = length / height;
    short_ = 2 * (length - run_ * height);
    long_ = 2 * height - short_;
    balance_ = (length - before_tie) % (2 * height) - long_;
  }

  std::int64_t first() const { return first_; }

  /// Length of the run after the last one asked for. The last run of the line may be shorter: it
  /// ends with the segment.
  std::int64_t next() {
    if (balance_ < 0) {
      balance_ += short_;
      return run_;
    }
    balance_ -= long_;
    return run_ + 1;
  }

 private:
  // The thesis's N, 2A', 2B' and 2IQ; doubled, because IQ begins with a half.
  std::int64_t first_ = 0, run_ = 0, short_ = 0, long_ = 0, balance_ = 0;
};

/// Loceff's line in space, by projection (thesis 2.2): its runs in the two planes that hold the
/// longest axis; a run in space ends where either does. In integers; the same voxels as
/// bresenham(), hence 26-connected, within half a voxel, and the same from either end.
template <class Visit>
void loceff(glm::ivec3 from, glm::ivec3 to, Visit&& visit) {
  const glm::ivec3 way = to - from;
  const int along = driving_axis(way), u = (along + 1) % 3, v = (along + 2) % 3;
  const glm::ivec3 sign = glm::sign(way);
  std::int64_t left = steps_between(from, to) + 1;
  LoceffRuns u_runs(left - 1, way[u]), v_runs(left - 1, way[v]);
  std::int64_t u_left = u_runs.first(), v_left = v_runs.first();
  for (;;) {
    const std::int64_t run = std::min({u_left, v_left, left});
    for (std::int64_t i = 0; i < run; ++i) {
      visit(from);
      from[along] += sign[along];
    }
    left -= run;
    if (left == 0) return;
    u_left -= run;
    v_left -= run;
    if (u_left == 0) {
      from[u] += sign[u];
      u_left = u_runs.next();
    }
    if (v_left == 0) {
      from[v] += sign[v];
      v_left = v_runs.next();
    }
  }
}

}  // namespace rc2::lines
