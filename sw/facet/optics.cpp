#include "sw/facet/optics.h"

#include <algorithm>
#include <cmath>

#include "sw/base/floor_divide.h"

namespace rc2::facet {
namespace {

std::uint16_t rounded(double value, int one) {
  return static_cast<std::uint16_t>(std::lround(value * one));
}

rays::Facet optics_of(const FacetInfo& facet, const scene::Material& material) {
  rays::Facet result;
  result.normal = slope_form(facet.plane.normal);
  result.mirror = rounded(material.mirror, rays::kShareOne);
  const auto left = static_cast<std::uint16_t>(rays::kShareOne - result.mirror);
  result.clear = std::min(left, rounded(material.transparency, rays::kShareOne));
  const double index = std::clamp<double>(material.refractive_index, 1, rays::kMaxIndex);
  result.enter = rounded(1 / index, rays::kIndexOne);
  result.leave = rounded(index, rays::kIndexOne);
  result.body = facet.body;
  return result;
}

}  // namespace

glm::ivec3 slope_form(const Vertex& normal) {
  const std::int64_t size = std::abs(normal[dominant_axis(normal)]);
  glm::ivec3 slope;
  for (int axis = 0; axis < 3; ++axis)
    slope[axis] =
        static_cast<int>(floor_divide(2 * (rays::kNormalOne * normal[axis]) + size, 2 * size));
  return slope;
}

std::vector<rays::Facet> find_optics(const std::vector<FacetInfo>& facets,
                                     const std::vector<scene::Material>& materials) {
  std::vector<rays::Facet> result;
  result.reserve(facets.size());
  for (const FacetInfo& facet : facets)
    result.push_back(optics_of(facet, materials[facet.material]));
  return result;
}

}  // namespace rc2::facet
