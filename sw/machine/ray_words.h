// What a machine with cells for rays is sent before a trace, and what it answers (rtl/rays).
//
// Two RAY words after a HEAD say how a facet reflects and refracts: every voxel of the HEAD's box
// that the facet owns keeps them. Two after the HEAD of one cell are its pixel's first ray.
#pragma once

#include <array>
#include <vector>

#include "sw/facet/packet.h"
#include "sw/machine/host_word.h"
#include "sw/machine/machine.h"

namespace rc2 {

/// The box of each facet's armour: where its voxels are.
struct FacetBox {
  std::uint32_t facet;
  glm::ivec3 lo, hi;
};

std::vector<FacetBox> boxes_of(const facet::PacketStream& packets);

/// The words for a feeder.
std::vector<HostWord> ray_words(const MachineConfig& config, const std::vector<FacetBox>& boxes,
                                const RayJob& job, int feeder);

/// The same words with their fields apart, as the cycle model moves them. Of a RAY word it knows
/// the sort only.
std::vector<Word> ray_word_sorts(const MachineConfig& config, const std::vector<FacetBox>& boxes,
                                 const RayJob& job, int feeder);

/// What the home of a pixel answers to a READ of its hits.
struct HomeRecord {
  std::vector<RayHit> hits;
  int rescued = 0, too_light = 0, too_deep = 0;
  std::int64_t probes = 0, planes = 0, run_on = 0, hops = 0;
  std::array<std::int64_t, kRayStages> work{};  ///< cycles of the cell's stages
};

/// From the values of its beats. Throws std::logic_error if they are not whole hits.
HomeRecord unpack_home(const MachineConfig& config, const glm::ivec2& home,
                       const std::vector<std::uint32_t>& values);

}  // namespace rc2
