// The generators behind generate(), one for each name.
#pragma once

#include <cstdint>

#include "sw/scene/scene.h"

namespace rc2::scene {

constexpr double kEdge = 2.0;  ///< voxels; edges of generated spheres are about this long

void generate_room(Scene& scene, int n);
void generate_gallery(Scene& scene, int n);

/// Area of a polygon times |nx|+|ny|+|nz|: the armoured slab is S = |A|+|B|+|C| thick in units in
/// which a voxel step along the normal is |N|, so a unit of area takes S/|N| voxels.
double armoured_voxels(const Scene& scene, std::size_t polygon);

/// Objects lie in voxel centres 1 .. n-2: the border layer with the cube's corners stays free.
void generate_shells(Scene& scene, int n, double percent, std::uint64_t seed);

/// Distinct voxels, no two of them 26-neighbours as long as such are easily found.
void generate_dust(Scene& scene, int n, double percent, std::uint64_t seed);

}  // namespace rc2::scene
