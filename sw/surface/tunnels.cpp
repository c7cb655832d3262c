#include "sw/surface/tunnels.h"

#include <array>

#include "sw/lines/neighbourhood.h"

namespace rc2::surface {

Tunnels count_tunnels(const VoxelSet& occupied, const VoxelArray<std::int32_t>& winding) {
  const int n = occupied.n();
  std::array<std::int64_t, 26> by_step{};
  for (glm::ivec3 p(0); p.z < n; ++p.z) {
    for (p.y = 0; p.y < n; ++p.y) {
      for (p.x = 0; p.x < n; ++p.x) {
        if (winding[p] == 0 || occupied[p] != 0) continue;
        for (std::size_t step = 0; step < by_step.size(); ++step) {
          const glm::ivec3 q = p + lines::kSteps[step];
          if (occupied.contains(q) && occupied[q] == 0 && winding[q] == 0) ++by_step[step];
        }
      }
    }
  }
  Tunnels tunnels;
  for (std::size_t step = 0; step < by_step.size(); ++step) {
    if (step < 6) tunnels.by_6 += by_step[step];
    if (step < 18) tunnels.by_18 += by_step[step];
    tunnels.by_26 += by_step[step];
  }
  return tunnels;
}

}  // namespace rc2::surface
