#include "sw/picture/compose.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "sw/machine/find_voxel.h"
#include "sw/scene/shade.h"

namespace rc2::picture {
namespace {

class Composer {
 public:
  Composer(const Traced& traced, const std::vector<Lamp>& lamps)
      : traced_(traced), lamps_(lamps), image_(blank(traced.n, lamps.size(), glm::vec3(0))) {
    for (const Lamp& lamp : lamps)
      if (!lamp.arrived.empty()) check_lamp(lamp, traced.voxels);
  }

  void add(const RayHit& hit) {
    const std::size_t pixel = image_.pixel(hit.ray.home.x, hit.ray.home.y);
    const float weight = static_cast<float>(hit.ray.weight) / rays::kWeightOne;
    if (hit.facet == RayHit::kNoFacet) {
      image_.colour[pixel] += weight * scene::kBackground;
      return;
    }
    if (hit.facet >= traced_.facets.size() ||
        traced_.facets[hit.facet].material >= traced_.materials.size())
      throw Error(
          fmt::format("a ray hit facet {}, of which the scene knows no normal or material: load "
                      "the machine with this scene",
                      hit.facet));
    const facet::FacetInfo& facet = traced_.facets[hit.facet];
    const glm::vec3 outward =
        traced_.smooth != nullptr
            ? glm::vec3(traced_.smooth->at(facet.polygon,
                                           glm::dvec3(hit.point) / double{rays::kPlaceOne}))
            : facet.normal;
    const glm::vec3 normal = hit.is_back ? -outward : outward;
    const bool is_first = hit.ray.node == 1;
    if (is_first) {
      const glm::vec3 way = glm::vec3(hit.point - hit.ray.origin) / float{rays::kPlaceOne};
      image_.depth[pixel] = glm::length(way);
      image_.normal[pixel] = normal;
      image_.facet[pixel] = hit.facet;
    }
    const bool is_way = hit.is_back && facet.body == rays::Body::solid;
    if (!is_way)
      image_.colour[pixel] += weight * shade(hit, traced_.materials[facet.material], normal);
  }

  // Pixels without a ray show the background.
  Image take(const std::vector<bool>& has_ray) {
    for (std::size_t pixel = 0; pixel < has_ray.size(); ++pixel)
      if (!has_ray[pixel]) image_.colour[pixel] = scene::kBackground;
    return std::move(image_);
  }

  std::size_t pixel(const RayHit& hit) const {
    return image_.pixel(hit.ray.home.x, hit.ray.home.y);
  }

 private:
  glm::vec3 shade(const RayHit& hit, const scene::Material& material, const glm::vec3& normal) {
    const glm::vec3 to_eye = -glm::normalize(glm::vec3(hit.ray.direction));
    const glm::vec3 point = glm::vec3(hit.point) / float{rays::kPlaceOne};
    const VoxelRecord* voxel = find_voxel(traced_.voxels, hit.voxel);
    if (voxel == nullptr)
      throw Error(
          "a ray hit a voxel that is not occupied: read the voxels from the machine that "
          "traced it");
    glm::vec3 colour = scene::own_light(material);
    for (std::size_t k = 0; k < lamps_.size(); ++k) {
      const Lamp& lamp = lamps_[k];
      if (!lamp.arrived.empty()) {
        const auto number = static_cast<std::size_t>(voxel - traced_.voxels.data());
        const std::uint32_t arrived = lamp.arrived[number];
        if (hit.ray.node == 1) image_.lights[k][pixel(hit)] = arrived;
        if (arrived == 0) continue;
      }
      const glm::vec3 to_lamp = glm::vec3(lamp.voxel) - point;
      const float distance = glm::length(to_lamp);
      if (distance == 0) continue;
      colour += scene::thrown_back(material, normal, to_eye, to_lamp / distance) *
                scene::faded(lamp.colour, distance, traced_.n);
    }
    return colour;
  }

  const Traced& traced_;
  const std::vector<Lamp>& lamps_;
  Image image_;
};

}  // namespace

Image compose(const Traced& traced, const std::vector<Lamp>& lamps, int depth) {
  Composer composer(traced, lamps);
  std::vector<bool> has_ray(static_cast<std::size_t>(traced.n) * traced.n);
  for (const RayHit& hit : traced.hits) {
    if (rays::depth_of(hit.ray.node) > depth) continue;
    has_ray[composer.pixel(hit)] = true;
    composer.add(hit);
  }
  return composer.take(has_ray);
}

}  // namespace rc2::picture
