#pragma once

#include "sw/lines/digital_line.h"
#include "sw/lines/segment.h"

namespace rc2::lines {

/// Bresenham's line in space (thesis 2.3.1), in integers: one voxel per step along the longest
/// axis, each coordinate the integer nearest to the segment, ties downwards. 26-connected; no
/// coordinate is off by more than half a voxel; the same voxels from either end.
///
/// The thesis rounds ties away from the first point instead, which draws other voxels on the way
/// back. Downwards is the rule of its light (4.3.1), and this is the same walk.
template <class Visit>
void bresenham(glm::ivec3 from, glm::ivec3 to, Visit&& visit) {
  const glm::ivec3 way = to - from;
  const int steps = steps_between(from, to);
  DigitalLine x(way.x, steps), y(way.y, steps), z(way.z, steps);
  visit(from);
  for (int step = 0; step < steps; ++step) {
    from += glm::ivec3(x.advance(), y.advance(), z.advance());
    visit(from);
  }
}

}  // namespace rc2::lines
