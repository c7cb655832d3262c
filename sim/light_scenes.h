// Scenes on which the error of light is measured.
#pragma once

#include <string>

#include "sw/scene/scene.h"

namespace rc2 {

/// A file that Assimp reads, so placed that its longest side is 0.7 n in the middle of the n-cube;
/// a generated scene (scene::generate); or one of these, the same for every n but for its scale:
///  - sphere        20480 triangles, radius 0.3 n
///  - boxes, tori   eight, turned
///  - plates:T      eight boxes, T voxels thick, turned
///  - sheets        eight squares without thickness, turned
/// Bodies do not touch; all but the sheets are closed. Throws Error.
scene::Scene make_light_scene(const std::string& name, int n);

}  // namespace rc2
