#pragma once

#include "sim/options.h"
#include "sw/facet/facet.h"
#include "sw/scene/scene.h"

namespace rc2 {

/// A scene in voxel coordinates and its packets.
struct Job {
  scene::Scene scene;
  facet::FacetSet facets;
};

/// Reads or generates the scene and fits it if asked to. Throws Error.
scene::Scene read_scene(const SceneOptions& options);

/// Reads the scene and builds its facets, with all layers (facet::build_layers) if asked to.
/// Throws Error.
Job prepare(const SceneOptions& options, bool with_layers = false);

}  // namespace rc2
