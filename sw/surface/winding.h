// What lies inside a mesh, exactly: the oracle for everything that separates inside from outside.
#pragma once

#include <cstdint>

#include "sw/surface/mesh.h"
#include "sw/surface/voxel_array.h"

namespace rc2::surface {

/// For each voxel of an n-cube how often the mesh goes round its centre: 0 outside, 1 inside one
/// shell whose facets turn counter-clockwise seen from outside, -1 inside one that is inside out,
/// sums where shells overlap. Its lowest bit is the parity of the facets that a ray crosses.
///
/// Exact integers. A voxel centre p counts as p + (e, e^2, e^3) with e -> 0+, so none lies on the
/// mesh and no ray meets an edge; rules with half-open bounds do the same. Rays go towards +z; if
/// the mesh is not closed, the direction matters and the numbers mean nothing.
///
/// Takes 4 n^3 bytes, and time for n^3 voxels and the columns in the facets' boxes. Coordinates
/// below 2^19 cannot overflow.
VoxelArray<std::int32_t> winding_numbers(const Mesh& mesh, int n);

}  // namespace rc2::surface
