// Rendering: the rays that a machine is asked to follow, and what it answers (docs/render.md).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/base/config.h"
#include "sw/rays/ray.h"
#include "sw/rays/split.h"

namespace rc2 {

/// Where a pixel's ray starts, if not from the viewer's plane.
struct RayStart {
  glm::ivec3 origin;     ///< in the cube, 1/64 voxel
  glm::ivec3 direction;  ///< unit vector, rays::direction_fraction(n) fraction bits; 0: no ray
};

/// The pixels' rays and their trees.
struct RayJob {
  rays::Limits limits;
  /// Of each facet, how it reflects and refracts: it reaches the voxels through their owners.
  const std::vector<rays::Facet>* facets;
  /// Row by row from y = 0, n * n of them; null: the viewer looks along -z from the cube's front.
  const std::vector<RayStart>* starts = nullptr;
  int queue = 2;  ///< places of each queue of the network; golden has none
};

/// One ray that has ended.
struct RayHit {
  static constexpr std::uint32_t kNoFacet = 0xFFFFFFFF;

  rays::Ray ray;
  std::uint32_t facet;  ///< kNoFacet: the ray left the cube, and what follows means nothing
  bool is_back;         ///< the facet's inner side, from within glass or behind a sheet
  glm::ivec3 voxel;     ///< whose owner was hit
  glm::ivec3 point;     ///< 1/64 voxel
};

bool operator==(const RayHit& a, const RayHit& b);

/// What became of the rays: issued = hits + escaped.
struct RayCounts {
  std::array<std::int64_t, rays::kMaxDepth + 1> issued{};  ///< by depth
  std::int64_t hits = 0;                                   ///< rays that ended on a facet
  std::int64_t escaped = 0;                                ///< rays that left the cube
  std::int64_t rescued = 0;                                ///< of the hits, those by the safety net
  std::int64_t too_light = 0;  ///< rays not sent because of their weight
  std::int64_t too_deep = 0;   ///< rays not sent because of the limit of depth
  std::int64_t probes = 0;     ///< columns looked into
  std::int64_t planes = 0;     ///< facets that rays were held against

  std::int64_t total() const;
};

bool operator==(const RayCounts& a, const RayCounts& b);

/// What a cell does with rays, each at the same time as the others (docs/render.md).
enum class RayStage : std::uint8_t { look, read, launch, meet };
constexpr std::size_t kRayStages = 4;
constexpr std::array<const char*, kRayStages> kRayStageNames{"look", "read", "launch", "meet"};

/// How the rays travelled; 0 on golden; latency, waits, messages, busiest_link and max_stack 0 on
/// rtl. Rays begun = first
/// rays + run_on + sent_again.
struct RayTraffic {
  std::int64_t load_cycles = 0;  ///< of sending surfaces and first rays to the cells, before that
  std::int64_t cycles = 0;       ///< from the start to the last answer at home
  /// Of each stage, the cycles that the busiest cell's units were at work, and did not wait.
  std::array<std::int64_t, kRayStages> work{};
  RayUnits units;            ///< that a cell has
  std::int64_t latency = 0;  ///< of the longest chain of rays and its way home, if nothing waited
  std::int64_t hops = 0;     ///< of rays, from cell to cell
  std::int64_t waits = 0;    ///< cycles that rays spent with nothing left to do but to go on
  std::int64_t answers = 0;  ///< hits that came home
  std::int64_t run_on = 0;   ///< rays that began where their parent ended
  std::int64_t sent_again = 0;    ///< rays that went home first, because there was no room for them
  std::int64_t max_stack = 0;     ///< most rays that waited at a home
  std::int64_t messages = 0;      ///< over all links: rays, starts and answers
  std::int64_t busiest_link = 0;  ///< over the one with the most

  /// No machine with so many units in a cell takes less.
  struct Busiest {
    std::int64_t cycles;
    const char* stage;
  };
  Busiest busiest() const;
};

struct RayResult {
  std::vector<RayHit> hits;  ///< all rays, sorted by y, x of the pixel, then node
  RayCounts counts;
  RayTraffic traffic;
};

/// Puts the hits into their order.
void sort_hits(std::vector<RayHit>& hits);

/// The ray of a pixel of a viewer who looks along -z.
rays::Ray primary_ray(const glm::ivec2& pixel, int n);

/// Likewise, or as the job says; direction 0 if it has none.
rays::Ray first_ray(const RayJob& job, const glm::ivec2& pixel, int n);

}  // namespace rc2
