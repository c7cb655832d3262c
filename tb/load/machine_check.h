// Many facets in one load: the golden machine and the cycle model against the oracle and each
// other.
#pragma once

#include <cstdint>

#include "sw/facet/facet.h"
#include "sw/machine/machine.h"
#include "tb/load/facet_case.h"
#include "tb/load/golden_check.h"

namespace rc2::facet {

/// Facets of one cube that are at least `apart` voxels from each other, so that no one can hide a
/// wrong voxel of another. Those of a case of duplicates do lie on each other.
std::vector<Border> draw_apart(std::uint64_t seed, std::int64_t number, const Cube& cube, int cases,
                               int apart);

/// A number of row feeders that a machine of this side can have.
int random_feeders(int n, Dice& dice);

/// Loads the facets into each machine (cube.n cells per side, at least cube.fraction_bits) and
/// compares every voxel of the cube: occupied if and only if the oracle gives it to a facet, the
/// owner one of those, one that has it in its core if there is any, its gap what the geometry says,
/// and all the same in all machines. Throws Difference. Returns the number of occupied voxels.
std::int64_t check_machines(const std::vector<Machine*>& machines,
                            const std::vector<Border>& borders, const Cube& cube, Rule rule);

}  // namespace rc2::facet
