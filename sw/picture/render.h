// The picture that a lit machine holds: each pixel is a column and shows its foremost voxel.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sw/facet/facet.h"
#include "sw/machine/machine.h"
#include "sw/picture/image.h"
#include "sw/scene/scene.h"

namespace rc2::picture {

/// A point light at the centre of a voxel, and what its diffusion left in the machine.
struct Lamp {
  glm::ivec3 voxel;
  glm::vec3 colour;  ///< linear RGB
  LightMemory arrived;
};

/// Shades the foremost voxel of each column, seen along -z from z = +infinity (thesis 1.1):
/// emission + Ka Ia + sum of (Kd N.L + Ks (N.H)^m) E over the lamps that reach the voxel, where
/// Ka = Kd, H is Blinn's half vector, and E fades gently with the distance, which gives shape to
/// flat walls: E = colour / (1 + (distance/n)^2), the same picture at every n.
/// A normal that points away from the viewer is turned round, so that single sheets have two
/// sides. A material of shininess 0 has no highlight.
/// Throws Error if voxels, lamps, facets and materials do not belong together.
Image render(int n, const VoxelMemory& voxels, const std::vector<Lamp>& lamps,
             const std::vector<facet::FacetInfo>& facets,
             const std::vector<scene::Material>& materials);

}  // namespace rc2::picture
