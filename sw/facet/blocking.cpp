#include "sw/facet/blocking.h"

namespace rc2::facet {

bool turns_away(const FacetInfo& facet, glm::ivec3 light, int fraction_bits) {
  // A component of a normal is below 2^37 (coefficient_bits) and a place below 2^18, so a sum of
  // three products fits.
  const Vertex place = Vertex(light) * (std::int64_t{1} << fraction_bits);
  return dot(facet.plane.normal, place) <= facet.plane.level;
}

std::vector<bool> find_blocking(const std::vector<FacetInfo>& facets, glm::ivec3 light,
                                int fraction_bits) {
  std::vector<bool> blocking;
  blocking.reserve(facets.size());
  for (const FacetInfo& facet : facets)
    blocking.push_back(facet.is_crowded || turns_away(facet, light, fraction_bits));
  return blocking;
}

}  // namespace rc2::facet
