// Where lights stand that look for trouble, and how far their virtual faces are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tb/load/dice.h"
#include "tb/stress/light_oracle.h"

namespace rc2::stress {

using facet::Dice;

/// A free voxel in a corner, on an edge and on a face of the n-cube, beside a facet, inside a solid
/// and anywhere, each with its name; those that are not found soon are left out.
std::vector<std::pair<const char*, glm::ivec3>> choose_sources(const LightOracle& oracle, int n,
                                                               Dice& dice);

/// A distance L from 1 to 8n or, in small cubes, the largest there is, with its name.
std::pair<std::string, int> draw_distance(int n, Dice& dice);

}  // namespace rc2::stress
