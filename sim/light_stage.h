// A scene in the golden machine beside its continuous original: where lights are compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/light_compare.h"
#include "sw/facet/facet.h"
#include "sw/scene/scene.h"
#include "sw/truth/samples.h"

namespace rc2 {

constexpr int kStageLights = 6;

struct LightStage {
  /// make_light_scene(name, side) with all layers, vertices rounded to 2^-f, or, by another rule
  /// than armoured, with none but that all its voxels are shown. Throws Error, also if there is
  /// nothing to light. `coefficient_bits`: slabs are rounded to so many bits and widened, see
  /// surface::round_slabs; otherwise they are exact.
  LightStage(const std::string& name, int side, int f, facet::Rule rule,
             std::optional<int> coefficient_bits, const Progress& progress);

  /// The free voxel nearest to one of kStageLights places: all round a scene, near the walls of a
  /// room. Throws Error if there is none.
  glm::ivec3 light(int number) const;

  /// Of each shown voxel, in the order of shown.places().
  std::vector<truth::Verdict> judge(const glm::ivec3& light) const;

  /// Of each facet, whether it turns away from the light.
  std::vector<bool> away(const glm::ivec3& light) const;

  std::string title;  ///< the scene's name without its folder
  int n, fraction_bits;
  scene::Scene scene;
  double packet_seconds = 0, load_seconds = 0;  ///< polygons -> packets -> voxels, processor time
  facet::FacetSet facets;
  LayerMemory layers;
  VoxelMemory voxels;
  Shown shown;
  truth::Surface surface;
  truth::Samples samples;
};

}  // namespace rc2
