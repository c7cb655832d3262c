#include "sw/thesis/split.h"

#include <algorithm>
#include <cstdlib>

namespace rc2::thesis {
namespace {

// The thesis's Y_med, with [ ] read as floor: the last target of those at `offset`.
int last_target(int offset, int steps, int distance) {
  const std::int64_t dividend = (2LL * offset + 1) * distance;
  const std::int64_t divisor = 2LL * steps;
  const std::int64_t quotient = dividend / divisor;
  return static_cast<int>(dividend % divisor < 0 ? quotient - 1 : quotient);
}

Interval common(Interval a, Interval b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

}  // namespace

Partition::Partition(int n, int distance) : n_(n) {
  for (int steps = 1; steps <= n; ++steps) {
    for (int offset = -n - 1; offset <= n; ++offset) {
      last_.push_back(last_target(offset, steps, distance));
    }
  }
}

Children Partition::split(const Beam& beam, glm::ivec3 at) const {
  const auto [u_axis, v_axis] = target_axes(beam.axis);
  const int steps = std::abs(at[beam.axis]) + 1;
  Children children;
  for (const int du : {-1, 0, 1}) {
    const Interval u = common(beam.u, through(at[u_axis] + du, steps));
    if (u.empty()) continue;
    for (const int dv : {-1, 0, 1}) {
      const Interval v = common(beam.v, through(at[v_axis] + dv, steps));
      if (v.empty()) continue;
      glm::ivec3 step(0);
      step[beam.axis] = beam.side;
      step[u_axis] = du;
      step[v_axis] = dv;
      children.push_back({step, {beam.axis, beam.side, u, v}});
    }
  }
  return children;
}

}  // namespace rc2::thesis
