// From the lights of the command line or the scene to source voxels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sw/picture/render.h"
#include "sw/report/report.h"
#include "sw/scene/scene.h"

namespace rc2 {

struct Lamp {
  std::string origin;  ///< how the user knows it, for messages
  glm::ivec3 voxel;
  glm::vec3 colour;  ///< linear RGB
};

struct Lamps {
  std::vector<Lamp> list;
  report::LightCounts counts;
};

/// The lights asked for ("x,y,z" or "x,y,z,r,g,b"; voxels), else those of the scene that round to
/// a voxel of the cube. Throws Error on a word that is no light or lies outside.
Lamps choose_lamps(const std::vector<std::string>& asked, const scene::Scene& scene, int n);

/// Adds a white lamp in the free voxel nearest to (n/4, 3n/4, n-1), the side of the viewer, if
/// there is none, then throws Error if a lamp stands in an occupied voxel. `voxels` is what the
/// machine loaded.
void place_lamps(Lamps& lamps, const VoxelMemory& voxels, int n);

/// The lamps and what they left behind, together.
std::vector<picture::Lamp> lit_lamps(const std::vector<Lamp>& lamps,
                                     const std::vector<LightMemory>& arrived);

/// The free voxel nearest to a place; none if all are occupied.
std::optional<glm::ivec3> nearest_free(const VoxelMemory& voxels, glm::ivec3 place, int n);

}  // namespace rc2
