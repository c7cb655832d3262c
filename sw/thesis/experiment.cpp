#include "sw/thesis/experiment.h"

#include <algorithm>
#include <utility>

namespace rc2::thesis {
namespace {

// The thesis aims at n - 1 from any source. A cube of one voxel never splits a beam, but its rays
// need a face to aim at all the same.
int thesis_distance(int n) { return std::max(1, n - 1); }

Experiment from_corner(int n, std::vector<Beam> cones) {
  return {n, thesis_distance(n), glm::ivec3(0), std::move(cones), {}};
}

}  // namespace

Experiment one_cone(int n, int axis) {
  const Interval quarter{0, thesis_distance(n)};
  return from_corner(n, {{axis, 1, quarter, quarter}});
}

Experiment corner(int n, std::optional<int> fa, Conflict conflict) {
  const Interval quarter{0, thesis_distance(n)};
  Experiment experiment = from_corner(
      n, {{0, 1, quarter, quarter}, {1, 1, quarter, quarter}, {2, 1, quarter, quarter}});
  experiment.fa = fa;
  experiment.conflict = conflict;
  return experiment;
}

Experiment centre(int n, std::optional<int> fa, Conflict conflict) {
  const int distance = thesis_distance(n);
  const Interval face{-distance, distance};
  std::vector<Beam> cones;
  for (const int axis : {0, 1, 2}) {
    for (const int side : {1, -1}) cones.push_back({axis, side, face, face});
  }
  return {n, distance, glm::ivec3((n - 1) / 2), std::move(cones), fa, conflict};
}

Experiment plane(int n) { return from_corner(n, {{0, 1, {0, thesis_distance(n)}, {0, 0}}}); }

Experiment one_by_one(Experiment experiment) {
  std::vector<Beam> rays;
  for (const Beam& cone : experiment.cones) {
    for (int v = cone.v.first; v <= cone.v.last; ++v) {
      for (int u = cone.u.first; u <= cone.u.last; ++u) {
        rays.push_back({cone.axis, cone.side, {u, u}, {v, v}});
      }
    }
  }
  experiment.cones = std::move(rays);
  return experiment;
}

}  // namespace rc2::thesis
