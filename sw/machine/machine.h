// The one interface through which a host runs RC2, whatever the machine is made of.
//
// Three implementations exist: golden (sw/golden, no notion of time), cycle (sw/cycle, register
// true) and rtl (sim, the Verilated array). A regression is the same job on two of them.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/facet/packet.h"
#include "sw/machine/claim.h"
#include "sw/machine/ray_job.h"

namespace rc2 {

/// Where light ends (docs/light.md).
///  - thesis    in every occupied voxel (4.3)
///  - accurate  where the owner turns away from the light, inside solids and behind sheets; what
///              faces the light is lit and passed. Needs all layers.
enum class LightRule { thesis, accurate };

/// Throws Error on an unknown word.
LightRule parse_light_rule(const std::string& word);
const char* to_string(LightRule rule);

/// One light's diffusion (thesis 4.3): source voxel, distance L of the virtual faces, depth of FA.
struct LightJob {
  glm::ivec3 source;
  int target_distance;
  int fa;
  LightRule rule = LightRule::thesis;
};

/// Number of targets of one source: the surface of the cube of half-side L, each edge once.
constexpr std::int64_t total_targets(std::int64_t target_distance) {
  return 24 * target_distance * target_distance + 2;
}

/// Where the targets of one source went. Conservation: absorbed + escaped + skipped = total.
struct TargetCount {
  std::int64_t total = 0, absorbed = 0, escaped = 0, skipped = 0;
};

struct LoadResult {
  std::int64_t cycles = 0;  ///< first word accepted .. last register at rest; 0 on golden
};

struct LightResult {
  std::int64_t prepare_cycles = 0;  ///< for the columns to see where this light ends; 0 on golden
  std::int64_t cycles = 0;          ///< start .. last busy cycle of any cell; 0 on golden
  std::int64_t home_cycles = 0;     ///< start .. last target counted home at the root; 0 on golden
  std::int64_t visits = 0;          ///< beams served by all cells (golden: voxels examined by rays)
  std::int64_t merged = 0;          ///< beams that were merged into another
  std::int64_t max_queue = 0;       ///< deepest FA seen in any cell; 0 on golden
  TargetCount targets;
  /// A signature of the depth of every queue in every cycle (QueueHistory); 0 on golden.
  std::uint64_t queue_history = 0;
};

/// An occupied voxel and its owner.
struct VoxelRecord {
  glm::ivec3 at;
  Claim owner;
};

inline bool operator==(const VoxelRecord& a, const VoxelRecord& b) {
  return a.at == b.at && a.owner == b.owner;
}

/// Occupied voxels sorted by z, then y, then x: the order of every dump.
using VoxelMemory = std::vector<VoxelRecord>;

/// What a voxel is part of; see facet::Layer.
struct LayerRecord {
  glm::ivec3 at;
  bool armour, shown, inside, guard;  ///< guard only without armour
};

inline bool operator==(const LayerRecord& a, const LayerRecord& b) {
  return std::tie(a.at.x, a.at.y, a.at.z, a.armour, a.shown, a.inside, a.guard) ==
         std::tie(b.at.x, b.at.y, b.at.z, b.armour, b.shown, b.inside, b.guard);
}

/// Every voxel that is part of any layer, sorted by z, then y, then x.
using LayerMemory = std::vector<LayerRecord>;

/// Targets that arrived at each occupied voxel, whether they ended there or went on, in the order
/// of VoxelMemory.
using LightMemory = std::vector<std::uint32_t>;

/// Called now and then during a long step: the step's name, cycles so far, share done (0..1).
using Progress = std::function<void(const char* step, std::int64_t cycles, double share)>;

/// Sees a cycle of a light: its number and, for each cell y*n + x, the number of beams in its queue
/// as the registers hold it in that cycle.
using QueueObserver =
    std::function<void(std::int64_t cycle, const std::vector<std::uint32_t>& queues)>;

class Machine {
 public:
  virtual ~Machine() = default;

  virtual const MachineConfig& config() const = 0;

  /// Empties the machine and loads the packets. Throws Error if a packet is out of its range.
  virtual LoadResult load(const facet::PacketStream& packets, const Progress& progress) = 0;

  /// Forgets the previous light and diffuses this one. The source voxel must be free.
  virtual LightResult light(const LightJob& job, const Progress& progress) = 0;

  /// Calls `observer` in every cycle of every light from now on; none if it is empty. The cycle
  /// model counts from the start of the light, its first cycle being 1; the Verilated array from
  /// its reset, beginning with the start of the light. A machine without cycles never calls.
  virtual void observe(const QueueObserver& /*observer*/) {}

  virtual VoxelMemory read_voxels() = 0;

  virtual LayerMemory read_layers() = 0;

  /// Follows the rays of every pixel and of what they become (thesis 1.3.2). Changes nothing that
  /// the machine holds. Throws Error if the job is out of range, or if this machine traces no rays.
  virtual RayResult trace(const RayJob& /*job*/, const Progress& /*progress*/) {
    throw Error("this machine traces no rays yet; use --machine golden or cycle");
  }

  /// What the last light() since load() left behind, in the order of read_voxels(); zeros if there
  /// was none.
  virtual LightMemory read_light() = 0;
};

}  // namespace rc2
