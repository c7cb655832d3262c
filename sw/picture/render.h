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

/// Throws Error unless the lamp's memory is one of these voxels.
void check_lamp(const Lamp& lamp, const VoxelMemory& voxels);

/// A picture in which nothing is seen.
Image blank(int n, std::size_t lamps, const glm::vec3& colour);

/// Shades the foremost voxel of each column, seen along -z from z = +infinity, by
/// sw/scene/shade.h and the lamps that reach the voxel.
/// A normal that points away from the viewer is turned round, so that single sheets have two
/// sides.
/// Depth counts from the plane z = n - 1/2 to the centre of the voxel. Throws Error if voxels,
/// lamps, facets and materials do not belong together.
Image render(int n, const VoxelMemory& voxels, const std::vector<Lamp>& lamps,
             const std::vector<facet::FacetInfo>& facets,
             const std::vector<scene::Material>& materials);

}  // namespace rc2::picture
