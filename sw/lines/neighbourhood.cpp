#include "sw/lines/neighbourhood.h"

#include <glm/common.hpp>

namespace rc2::lines {
namespace {

constexpr int kCells = 27, kCentre = 13;

constexpr Neighbourhood bit(int cell) { return Neighbourhood{1} << cell; }

glm::ivec3 place(int cell) { return {cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1}; }

// How many coordinates a step changes; 0 if it leads beyond the 26 neighbours.
int changes(glm::ivec3 step) {
  const glm::ivec3 by = glm::abs(step);
  return by.x > 1 || by.y > 1 || by.z > 1 ? 0 : by.x + by.y + by.z;
}

std::array<glm::ivec3, 26> steps_faces_first() {
  std::array<glm::ivec3, 26> steps;
  std::size_t count = 0;
  for (int changed = 1; changed <= 3; ++changed)
    for (int cell = 0; cell < kCells; ++cell)
      if (changes(place(cell)) == changed) steps[count++] = place(cell);
  return steps;
}

// near[a][cell]: the cells of the neighbourhood that are neighbours of `cell` by kAdjacencies[a].
using Near = std::array<std::array<Neighbourhood, kCells>, 3>;

Near neighbours_of_cells() {
  Near near{};
  for (int from = 0; from < kCells; ++from) {
    for (int to = 0; to < kCells; ++to) {
      const int changed = changes(place(to) - place(from));
      for (int a = changed; changed > 0 && a <= 3; ++a)
        near[static_cast<std::size_t>(a - 1)][static_cast<std::size_t>(from)] |= bit(to);
    }
  }
  return near;
}

const Near kNear = neighbours_of_cells();

// Whether steps of an adjacency lead from the centre to `target` through cells of `within`.
bool reaches(std::size_t adjacency, Neighbourhood within, int target) {
  Neighbourhood reached = bit(kCentre), fresh = reached;
  while (fresh != 0 && (reached & bit(target)) == 0) {
    Neighbourhood next = 0;
    for (int cell = 0; cell < kCells; ++cell)
      if ((fresh & bit(cell)) != 0) next |= kNear[adjacency][static_cast<std::size_t>(cell)];
    fresh = next & within & ~reached;
    reached |= fresh;
  }
  return (reached & bit(target)) != 0;
}

}  // namespace

const std::array<glm::ivec3, 26> kSteps = steps_faces_first();

Adjacency local_connectivity(Neighbourhood around) {
  const std::size_t corner = index_of(Adjacency::corner);
  std::size_t strongest = 0;
  for (int cell = 0; cell < kCells; ++cell) {
    if (cell == kCentre || (around & bit(cell)) == 0) continue;
    const Neighbourhood of_both =
        around & (kNear[corner][static_cast<std::size_t>(cell)] | bit(cell));
    while (strongest < corner && !reaches(strongest, of_both, cell)) ++strongest;
  }
  return kAdjacencies[strongest];
}

}  // namespace rc2::lines
