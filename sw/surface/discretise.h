// Every way of this project to make voxels of a mesh, the thesis's three included.
#pragma once

#include <array>

#include "sw/scene/scene.h"
#include "sw/surface/voxel_array.h"

namespace rc2::surface {

/// Up to blindee the rules of facet::Rule (thesis 3.4 and on), then thesis 3.2 and 3.3.
enum class Discretiser { armoured, naive, supercover, half, blindee, bilinear, slices };

constexpr std::array<Discretiser, 7> kDiscretisers = {
    Discretiser::armoured, Discretiser::naive,    Discretiser::supercover, Discretiser::half,
    Discretiser::blindee,  Discretiser::bilinear, Discretiser::slices};

const char* to_string(Discretiser discretiser);

/// Fraction bits of the vertices: the machine's default; none for bilinear and slices, whose
/// corners are voxels.
int fraction_bits(Discretiser discretiser);

/// The voxels of a scene (voxel coordinates) in an n-cube. The facets of rules go through
/// the golden machine. Throws Error as facet::build_facets does.
VoxelSet discretise(const scene::Scene& scene, int n, Discretiser discretiser);

}  // namespace rc2::surface
