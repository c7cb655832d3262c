// How far up and down a scene reaches, seen from each cell (rtl/lanes/rc2_extents.sv).
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/cycle/column.h"

namespace rc2::cycle {

/// Voxels min .. max of a column.
struct Extent {
  int min, max;
  bool none() const { return max < min; }
};

/// Each cell keeps, for each of the four quadrants of the array that it is the corner of, the
/// lowest and the highest layer with an occupied voxel. Light never turns back along x or y, so all
/// that a beam can still meet is in the quadrant away from its light.
///
/// A cell's extent of a quadrant is its own column's joined with those of two neighbours: what is
/// loaded last is known to all after as many cycles as there are cells on the way, which is less
/// than 2n.
class Extents {
 public:
  explicit Extents(int n);

  /// Takes over what is in the columns now.
  void settle(const Columns& columns);

  /// Of each cell, layers with occupied voxels that light from `source` can reach once it is there.
  std::vector<Extent> beyond(const glm::ivec3& source) const;

 private:
  Extent& at(std::size_t quadrant, int x, int y);
  const Extent& at(std::size_t quadrant, int x, int y) const;

  int n_;
  // Quadrant sx + 2 sy: east if sx, north if sy.
  std::array<std::vector<Extent>, 4> quadrants_;
};

}  // namespace rc2::cycle
