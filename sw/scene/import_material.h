#pragma once

#include "sw/scene/scene.h"

struct aiMaterial;

namespace rc2::scene {

/// Maps Assimp's material to ours. Metal mirrors the more the smoother it is:
/// metallic * (1 - roughness)^2 (glTF); elsewhere reflectivity times the reflective colour.
/// A material without any opacity counts as opaque: nobody models what cannot be seen, but some
/// exporters write Collada's transparency the wrong way round.
Material import_material(const aiMaterial& source);

/// Number of images the material names.
std::int64_t texture_count(const aiMaterial& source);

}  // namespace rc2::scene
