// Connectivity of any set of voxels.
#pragma once

#include <optional>
#include <set>
#include <tuple>

#include "sw/lines/neighbourhood.h"

namespace rc2::lines {

struct VoxelOrder {
  bool operator()(const glm::ivec3& a, const glm::ivec3& b) const {
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
  }
};

using VoxelSet = std::set<glm::ivec3, VoxelOrder>;

/// The strongest adjacency whose steps lead from any voxel of the set to any other inside the set;
/// none if the set falls apart or is empty.
std::optional<Adjacency> connectivity(const VoxelSet& voxels);

/// The thesis's connectivity (2.1), which looks at pairs of neighbours only: a set in several
/// pieces has one too. See local_connectivity(Neighbourhood).
Adjacency local_connectivity(const VoxelSet& voxels);

}  // namespace rc2::lines
