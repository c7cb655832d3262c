// How far up and down a scene reaches, seen from each cell (rtl/lanes/rc2_extents.sv).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/cycle/column.h"
#include "sw/cycle/tilt.h"

namespace rc2::cycle {

/// Voxels min .. max of a column.
struct Extent {
  int min, max;
  bool none() const { return max < min; }
};

/// The layers of a cell in which light can still meet something, here or further on, as far as the
/// cell knows: at first only whether there is anything at all.
struct Outlook {
  Extent at_first, later;
  std::int64_t since;  ///< the first cycle of the light in which it knows
  const Extent& in(std::int64_t cycle) const { return cycle < since ? at_first : later; }
};

/// Light never turns back along x or y, so all that it can still meet is in the quadrant of the
/// array away from its source: whether there is anything in it, each cell hears as the scene is
/// loaded. A ray keeps its tilt (Tilt). So when a light starts each cell works out the tilts of the
/// rays that can meet its own column, and hears from the cells further out of those that can meet
/// something there: from ring to ring inwards, a cycle each, while the light comes outwards, two
/// cycles each. Of the scene it then knows which layers of light are worth while.
///
/// A *sector* is what light along the cell's main axis comes to: with each cell outward it keeps
/// its place on the other axis or moves outward there too. Light towards a z face may move along
/// the other axis alone, but once in a ring: a cell's outlook is on its own sector and its
/// neighbour's in the same ring.
class Extents {
 public:
  explicit Extents(int n);

  /// Takes over what is in the columns now.
  void settle(const Columns& columns);

  /// Of each cell, for a light that starts in cycle 0.
  std::vector<Outlook> seen_from(const glm::ivec3& source) const;

 private:
  struct Sector {
    Tilts tilts;
    std::int64_t since;
  };
  bool anything(int x, int y, const glm::ivec3& source) const;

  int n_;
  Tilt tilt_;
  std::vector<Extent> own_;
  // Whether there is anything in quadrant sx + 2 sy of a cell: east if sx, north if sy.
  std::array<std::vector<bool>, 4> occupied_;
};

}  // namespace rc2::cycle
