#include "sim/drive.h"

#include <fmt/format.h>

#include "sw/report/laws.h"

namespace rc2 {

void Drive::load(const facet::FacetSet& facets) {
  load_ = machine_.load(facets.packets, bar_.step("loading on " + name_));
  memories_ = {machine_.read_voxels(), {}};
  bar_.wipe();
  report::check_voxels(memories_.voxels, machine_.config().n, facets.facets.size());
}

std::vector<LightResult> Drive::light(const std::vector<Lamp>& lamps, int target_distance, int fa,
                                      LightRule rule) {
  std::vector<LightResult> results;
  for (const Lamp& lamp : lamps) {
    const LightJob job{lamp.voxel, target_distance, fa, rule};
    const auto progress =
        bar_.step(fmt::format("light {} of {} on {}", results.size() + 1, lamps.size(), name_));
    results.push_back(machine_.light(job, progress));
    memories_.lights.push_back(machine_.read_light());
    report::check_light(results.back(), memories_.lights.back(), job, memories_.voxels.size());
  }
  bar_.wipe();
  return results;
}

RayResult Drive::trace(const RayJob& job) {
  RayResult result = machine_.trace(job, bar_.step("rays on " + name_));
  bar_.wipe();
  report::check_rays(result);
  return result;
}

}  // namespace rc2
