// Families of closed meshes on which leaks are counted.
#pragma once

#include <cstdint>
#include <vector>

#include "sw/scene/random.h"
#include "sw/scene/scene.h"

namespace rc2::surface {

struct MeshFamily {
  const char* name;
  int n;  ///< side of the cube, voxels, in which its members lie
  void (*add)(scene::Scene& scene, scene::Random& random);
};

/// Tetrahedra, flat ones, spheres, tori, boxes, plates, and boxes along the axes.
extern const std::vector<MeshFamily> kMeshFamilies;

/// A member of the family in voxel coordinates, closed, outside counter-clockwise, within voxel
/// centres 1 .. n-2. The same seed gives the same mesh with every compiler and library.
scene::Scene make_mesh(const MeshFamily& family, std::uint64_t seed);

}  // namespace rc2::surface
