#pragma once

#include "sw/scene/import_nodes.h"
#include "sw/scene/scene.h"

namespace rc2::scene {

/// Adds the lights that have a place, counts the others, scales the colours (see Light).
void import_lights(const aiScene& source, const std::vector<PlacedNode>& nodes, Scene& scene);

/// Sets the first camera of the file, if it is a usable one.
void import_camera(const aiScene& source, const std::vector<PlacedNode>& nodes, Scene& scene);

}  // namespace rc2::scene
