// Voxels next to a voxel (thesis 2.1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace rc2::lines {

/// Neighbours have at least a face in common, or an edge, or a corner; the value is their number.
/// In a plane, face and edge are the thesis's connectivities 4 and 8.
enum class Adjacency { face = 6, edge = 18, corner = 26 };

constexpr std::array<Adjacency, 3> kAdjacencies = {Adjacency::face, Adjacency::edge,
                                                   Adjacency::corner};

/// Place of an adjacency in kAdjacencies.
constexpr std::size_t index_of(Adjacency adjacency) {
  return adjacency == Adjacency::face ? 0 : (adjacency == Adjacency::edge ? 1 : 2);
}

/// The steps to the 26 neighbours; the first 6 go through faces, the next 12 through edges.
extern const std::array<glm::ivec3, 26> kSteps;

/// A voxel's 27-neighbourhood: bit (x+1) + 3(y+1) + 9(z+1) tells whether its neighbour at step
/// (x,y,z) belongs to the set in question. Bit 13 is the voxel itself.
using Neighbourhood = std::uint32_t;

/// The neighbourhood of `at` in the set of those voxels for which has(voxel).
template <class Has>
Neighbourhood neighbourhood(glm::ivec3 at, const Has& has) {
  Neighbourhood around = 0;
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    around |= static_cast<Neighbourhood>(has(at + step)) << i;
  }
  return around;
}

/// The thesis's connectivity of a set (2.1), seen from one of its voxels: the strongest adjacency
/// such that every neighbour of the set is reached from the voxel by steps of that adjacency
/// through voxels of the set that are neighbours of both. Corner always holds: the definition asks
/// nothing of such a set.
Adjacency local_connectivity(Neighbourhood around);

}  // namespace rc2::lines
