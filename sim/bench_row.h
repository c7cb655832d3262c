// One line of the benchmark's table: what was run, what it took, how wrong it was.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/light_compare.h"
#include "sim/light_stage.h"
#include "sw/picture/difference.h"

namespace rc2 {

/// Error of voxels as the continuous surface sees it.
struct VoxelError {
  std::int64_t voxels = 0;
  double uncovered_percent = 0;  ///< points of the surface more than 1/32 outside all voxels
  double distance = 0;           ///< mean, of the voxel's centre from the surface, in voxels
  std::optional<std::int64_t> tunnels_6, tunnels_26;  ///< through closed meshes
};

/// Empty: does not apply. Seconds are of one thread's processor time.
struct BenchRow {
  std::string scene, method, rule, light_rule, mode;
  int n = 0, fraction_bits = 0;
  std::optional<int> coefficient_bits;  ///< empty: exact
  std::optional<bool> skips;
  std::optional<int> distance, fa, light;
  glm::ivec3 at{0};
  std::int64_t facets = 0;
  VoxelError voxels;
  double prepare_seconds = 0;  ///< machines: polygons -> packets; peers: what is built once
  double load_seconds = 0;
  std::optional<double> light_seconds;
  std::optional<std::int64_t> load_cycles, light_cycles, visits, merged, deepest;
  std::optional<std::array<Errors, kPopulations.size()>> errors;
  std::optional<picture::Difference> picture;
};

VoxelError voxel_error(const LightStage& stage, const std::vector<glm::ivec3>& voxels);

/// What a picture of the shown voxels lit like this is off from Embree's of the same scene, one
/// light. `arrived` is in the order of VoxelMemory.
class PictureError {
 public:
  explicit PictureError(const LightStage& stage);
  picture::Difference compare(const glm::ivec3& light, const LightMemory& arrived) const;

 private:
  const LightStage& stage_;
  VoxelMemory drawn_;
  // Of each pixel in which a triangle is seen a voxel that belongs to it alone.
  VoxelMemory seen_;
  std::vector<facet::FacetInfo> triangles_;
  std::vector<glm::dvec3> at_;
};

/// The table as CSV, with commit and peak memory of this program in every line.
std::string to_csv(const std::vector<BenchRow>& rows);

}  // namespace rc2
