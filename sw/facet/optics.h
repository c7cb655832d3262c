// What the host tells a machine of its facets before rays are traced.
#pragma once

#include <vector>

#include "sw/facet/facet.h"

namespace rc2::facet {

/// Of each facet its rounded normal, the shares of light that it mirrors and lets through (rounded
/// to 1/256; together at most one), and how it bends light. A refractive index beyond
/// rays::kMaxIndex counts as that.
std::vector<rays::Facet> find_optics(const std::vector<FacetInfo>& facets,
                                     const std::vector<scene::Material>& materials);

/// A normal in slope form: divided by its largest component, rounded.
glm::ivec3 slope_form(const Vertex& normal);

}  // namespace rc2::facet
