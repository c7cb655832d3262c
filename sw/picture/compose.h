// The picture that the rays of a machine make.
#pragma once

#include "sw/machine/machine.h"
#include "sw/picture/render.h"
#include "sw/scene/smooth.h"

namespace rc2::picture {

/// What the rays have met and by what light it is seen.
struct Traced {
  int n;
  const VoxelMemory& voxels;
  const std::vector<facet::FacetInfo>& facets;
  const std::vector<scene::Material>& materials;
  const std::vector<RayHit>& hits;
  const scene::SmoothNormals* smooth = nullptr;  ///< what is shaded by; null: the facets' normals
};

/// Adds up what the hits of each pixel send to it (thesis 1.1, I_R and I_T): each is worth its
/// weight, and is shaded by sw/scene/shade.h where it was hit. A lamp counts where its light has
/// arrived at the voxel hit. Hits within glass are ways only and send nothing. Hits deeper than
/// `depth` are left out. The other channels are those of the first hit, `depth` counted in voxels
/// from where its ray starts, `normal` turned towards the ray.
/// Lamps whose memory is empty shine everywhere: the picture that can be shown before there is
/// light (thesis 1.3.2). Throws Error if hits and facets do not belong together.
Image compose(const Traced& traced, const std::vector<Lamp>& lamps, int depth);

}  // namespace rc2::picture
