// What a run tells: the same facts as report.json for programs and as a table for people.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sw/facet/facet.h"
#include "sw/machine/machine.h"
#include "sw/report/compare.h"

namespace rc2::report {

/// One light of the run, in the order of light0, light1, ... of the dump.
struct Source {
  glm::ivec3 voxel;
  glm::vec3 colour;  ///< linear RGB
  LightResult result;
  std::int64_t lit = 0;  ///< occupied voxels where at least one target arrived
};

/// Which lights there were to choose from.
struct LightCounts {
  std::int64_t read = 0;     ///< lights of the scene or of the command line
  std::int64_t used = 0;     ///< sources of the run
  std::int64_t outside = 0;  ///< lights of the scene outside the cube, skipped
  bool by_default = false;   ///< the source is not the scene's: it had none in the cube
};

/// What the file holds and the machine has no use for.
struct IgnoredCounts {
  std::int64_t primitives = 0, lights = 0, textures = 0;
};

struct Report {
  std::string scene;  ///< path or generated name
  std::string fit;    ///< "cube" or "none"
  std::string machine, rule, light_rule;
  std::string mode;    ///< of the light: "fast" or "thesis"
  int hop_stages = 0;  ///< cycles that light takes from a cell to the next
  int n = 0, fraction_bits = 0, target_distance = 0, fa = 0, feeders = 1;

  facet::FacetCounts facets;
  IgnoredCounts ignored;
  LightCounts lights;
  std::int64_t voxels = 0;
  LoadResult load;
  std::int64_t load_words = 0;  ///< of the busiest row feeder
  std::vector<Source> sources;

  std::string reference;  ///< the machine that this one was compared with
  Comparison agreement;

  std::vector<std::pair<std::string, double>> seconds;       ///< wall time of each step, in order
  std::vector<std::pair<std::string, std::string>> written;  ///< what it is, path
  std::string commit;                                        ///< of the source code
  std::vector<std::pair<std::string, std::string>> tools;    ///< name, version
};

/// The report as JSON, indented, ends with a line feed. Top level: scene, fit, machine, n,
/// fraction_bits, rule, light_rule, mode, L, fa, feeders, facets {read, triangulated, loaded,
/// degenerate, outside}, ignored {primitives, lights, textures}, lights {read, used, outside,
/// default}, cycles {load, prepare [per source], light [per source], home [per source],
/// hop_stages}, load_words, voxels, lit [per source], beams {visits, merged, max_queue} and targets
/// {total, absorbed, escaped, skipped} over all sources, sources [each with its own share],
/// agreement {reference, voxels_differing, owners_differing, lights_differing, first}, seconds,
/// files, commit, tools.
std::string to_json(const Report& report);

/// The report as aligned lines of text for a reader who has not seen one before.
std::string to_text(const Report& report);

}  // namespace rc2::report
