// A beam: all targets [umin..umax] x [vmin..vmax] of one face whose rays are at voxel z of the cell
// that holds it (thesis 4.3.4.1; beam_t in rtl/rc2_pkg.sv).
#pragma once

#include <cstdint>

namespace rc2::cycle {

/// Targets min..max along one axis.
struct Range {
  std::int16_t min, max;

  std::int64_t extent() const { return max - min + 1; }
};

inline Range range(int min, int max) {
  return {static_cast<std::int16_t>(min), static_cast<std::int16_t>(max)};
}

/// U is y on the x faces, else x; V is y on the z faces, else z.
struct Beam {
  Range u, v;
  std::uint16_t z;
  std::uint8_t dir;  ///< {axis, negative}: 0 +x, 1 -x, 2 +y, 3 -y, 4 +z, 5 -z

  bool along_x() const { return dir < 2; }
  bool along_y() const { return (dir & 6) == 2; }
  bool along_z() const { return dir >= 4; }
  bool negative() const { return (dir & 1) != 0; }
};

}  // namespace rc2::cycle
