// What the host tells a machine of its facets and one light: a bit each.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sw/facet/facet.h"

namespace rc2::facet {

/// Whether the facet turns away from a light in the middle of a voxel: the light lies behind its
/// plane or in it. Exact, from the rounded vertices (multiples of 2^-fraction_bits).
bool turns_away(const FacetInfo& facet, glm::ivec3 light, int fraction_bits);

/// Of each facet, whether the accurate rule ends light at it: because it turns away from the light,
/// or because it is crowded, when light ends as it does by the thesis's rule.
std::vector<bool> find_blocking(const std::vector<FacetInfo>& facets, glm::ivec3 light,
                                int fraction_bits);

}  // namespace rc2::facet
