#include "sw/peers/layer_sweep.h"

#include <algorithm>

namespace rc2::peers {
namespace {

// The coordinate in layer k-1 of the way to coordinate u in layer k, the tie inwards: u (k-1) / k
// lies half a voxel or more inwards if |u| is more than k / 2.
int parent(int u, int k) {
  if (2 * u > k) return u - 1;
  return -2 * u > k ? u + 1 : u;
}

}  // namespace

BitGrid sweep_layers(const BitGrid& stops, const glm::ivec3& light) {
  const int n = stops.n();
  BitGrid reached(n);
  reached.set(light);
  for (int axis = 0; axis < 3; ++axis) {
    const int u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    for (const int side : {-1, 1}) {
      const int last = side < 0 ? light[axis] : n - 1 - light[axis];
      for (int k = 1; k <= last; ++k) {
        const auto low = [&](int a) { return std::max(-k, -light[a]); };
        const auto high = [&](int a) { return std::min(k, n - 1 - light[a]); };
        for (int u = low(u_axis); u <= high(u_axis); ++u) {
          for (int v = low(v_axis); v <= high(v_axis); ++v) {
            glm::ivec3 at = light, from = light;
            at[axis] += side * k;
            at[u_axis] += u;
            at[v_axis] += v;
            from[axis] += side * (k - 1);
            from[u_axis] += parent(u, k);
            from[v_axis] += parent(v, k);
            if (reached.at(from) && (k == 1 || !stops.at(from))) reached.set(at);
          }
        }
      }
    }
  }
  return reached;
}

}  // namespace rc2::peers
