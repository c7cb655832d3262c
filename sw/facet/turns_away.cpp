#include "sw/facet/turns_away.h"

namespace rc2::facet {

bool turns_away(const FacetInfo& facet, glm::ivec3 light, int fraction_bits) {
  // A component of a normal is below 2^37 (coefficient_bits) and a place below 2^18, so a sum of
  // three products fits.
  const Vertex place = Vertex(light) * (std::int64_t{1} << fraction_bits);
  return dot(facet.plane.normal, place) <= facet.plane.level;
}

}  // namespace rc2::facet
