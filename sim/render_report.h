// What a rendering tells.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sw/machine/machine.h"

namespace rc2 {

struct RenderReport {
  std::string scene, machine, view, light_rule;
  bool has_unused_camera = false;  ///< the scene has one that the view does not use
  int n = 0, depth = 0, queue = 0;
  double least_weight = 0;
  std::int64_t facets = 0, lights = 0;
  const RayResult* result = nullptr;
  bool agrees = true;  ///< with golden, in every hit
  std::vector<std::string> written;
};

/// Top level: scene, machine, view, light_rule, unused_camera, n, depth, queue, least_weight,
/// facets, lights, rays {issued [by depth], hits, escaped, rescued, too_light, too_deep, probes,
/// planes}, traffic {load_cycles, cycles, busiest, busiest_cells {look, read, launch, meet},
/// latency, hops, waits, run_on, sent_again, max_stack, messages, busiest_link} (zeros on golden),
/// agrees_with_golden, files.
std::string to_json(const RenderReport& report);

/// The same for people.
std::string to_text(const RenderReport& report);

}  // namespace rc2
