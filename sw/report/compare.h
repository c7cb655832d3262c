#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sw/report/dump.h"

namespace rc2::report {

/// One value that two memories do not agree on; no value where the voxel is free.
struct Difference {
  glm::ivec3 at;
  std::string what;  ///< "facet", "core", "gap", "light0", "light1", ...
  std::optional<std::int64_t> expected, got;
};

constexpr std::size_t kFirstDifferences = 10;

struct Comparison {
  std::int64_t voxels_differing = 0;  ///< occupied on one side only
  std::int64_t owners_differing = 0;  ///< occupied on both sides, by different claims
  std::int64_t lights_differing = 0;  ///< counts of targets, over the voxels of both sides
  std::vector<Difference> first;      ///< the first kFirstDifferences in the order of z, y, x

  bool equal() const { return voxels_differing + owners_differing + lights_differing == 0; }
};

/// Compares voxel by voxel; both memories in order. A light that only one side has differs in
/// every voxel that both sides have.
Comparison compare(const Memories& expected, const Memories& got);

/// "voxel (1,2,3), light0: expected 5, got 4".
std::string to_string(const Difference& difference);

}  // namespace rc2::report
