// How steeply light goes up or down, as a cell reckons with it (rtl/lanes/rc2_extents.sv).
#pragma once

#include <cstdint>

namespace rc2::cycle {

/// Bounds on the tilt of rays: the layers that a ray rises while it goes one cell outward, dz / m,
/// m = max(|dx|, |dy|) from its source. A ray keeps its tilt. A tilt is a fixed-point number with a
/// bit of fraction more than a coordinate, so that it is off by less than half a voxel at the far
/// end of the array; from 8 layers a cell on, `most` stands for any.
class Tilt {
 public:
  explicit Tilt(int n);

  /// No ray at a voxel `rise` layers above the source and `distance` cells away from it has a
  /// higher tilt, or, with `high` unset, a lower one.
  int of(int rise, int distance, bool high) const;

  /// No ray with at most this tilt (or, `high` unset, at least) is in a higher layer (a lower one)
  /// above the source when it is `distance` cells away.
  int layer(int tilt, int distance, bool high) const;

  int most() const { return most_; }

  /// Cycles from the start of a light until each cell has divided for the tilts of its column.
  int divided() const { return divided_; }

 private:
  int n_, fraction_, most_, divided_;
};

/// Tilts min .. max; none if the lower is the higher.
struct Tilts {
  int min, max;
  bool none() const { return max < min; }
};

}  // namespace rc2::cycle
