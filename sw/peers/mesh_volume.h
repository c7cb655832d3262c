// Voxels of a mesh as OpenVDB makes them.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sw/truth/triangles.h"

namespace rc2::peers {

/// openvdb::tools::meshToUnsignedDistanceField, one thread: the voxels of the n-cube whose centres
/// are at most `distance` from the mesh, 0 < distance <= 1. Half a diagonal of a voxel, 0.867, is
/// what no 26-connected ray passes. In the order of the dumps.
std::vector<glm::ivec3> mesh_to_voxels(const truth::Triangles& triangles, int n, double distance);

}  // namespace rc2::peers
