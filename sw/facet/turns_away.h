#pragma once

#include <glm/vec3.hpp>

#include "sw/facet/facet.h"

namespace rc2::facet {

/// Whether the facet turns away from a light in the middle of a voxel: the light lies behind its
/// plane or in it. Exact, from the rounded vertices (multiples of 2^-fraction_bits).
bool turns_away(const FacetInfo& facet, glm::ivec3 light, int fraction_bits);

}  // namespace rc2::facet
