// How a cell parts a beam (thesis 4.3.1, 4.3.4).
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rc2::thesis {

/// The integers first .. last; none if last < first.
struct Interval {
  int first = 0, last = -1;

  bool empty() const { return last < first; }
  std::int64_t size() const { return empty() ? 0 : std::int64_t{last} - first + 1; }
};

/// Where a beam goes: along `axis` (0, 1, 2 for x, y, z), to its lower or upper face (side -1, +1),
/// and the targets on the virtual face, relative to the source; u and v follow the other two axes
/// in the order x, y, z.
struct Beam {
  int axis = 0;
  int side = 1;
  Interval u, v;

  std::int64_t targets() const { return u.size() * v.size(); }
};

struct Child {
  glm::ivec3 step;  ///< to the voxel it goes to, -1, 0 or 1 on each axis
  Beam beam;
};

using Children = boost::container::static_vector<Child, 9>;

/// The axes of u and v.
constexpr std::array<int, 2> target_axes(int axis) {
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

/// Which targets' digital rays go where, on a face at `distance`, in a cube of side n.
class Partition {
 public:
  Partition(int n, int distance);

  /// The targets whose rays are at `offset` after `steps` steps: those j for which it is the
  /// integer nearest to j * steps / distance, ties downwards. 1 <= steps <= n, |offset| <= n.
  Interval through(int offset, int steps) const {
    const int* last = last_.data() + std::ptrdiff_t{steps - 1} * (2 * n_ + 2) + offset + n_;
    return {last[0] + 1, last[1]};
  }

  /// Parts a beam that is `at` voxels away from its source: 1 to 9 children with all its targets.
  /// They differ in u first, then in v, lowest first.
  Children split(const Beam& beam, glm::ivec3 at) const;

 private:
  int n_;
  // The last target of each offset from -n-1 to n, step after step: a table, because the division
  // would take most of the time of a simulation.
  std::vector<int> last_;
};

}  // namespace rc2::thesis
