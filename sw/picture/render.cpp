#include "sw/picture/render.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "sw/scene/shade.h"

namespace rc2::picture {
namespace {

constexpr glm::vec3 kTowardsViewer(0, 0, 1);

}  // namespace

void check_lamp(const Lamp& lamp, const VoxelMemory& voxels) {
  if (lamp.arrived.size() == voxels.size()) return;
  throw Error(
      fmt::format("a light memory of {} voxels does not belong to a voxel memory of {}: read both "
                  "from the machine after the same load",
                  lamp.arrived.size(), voxels.size()));
}

Image blank(int n, std::size_t lamps, const glm::vec3& colour) {
  const std::size_t pixels = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  Image image;
  image.n = n;
  image.colour.assign(pixels, colour);
  image.depth.assign(pixels, std::numeric_limits<float>::infinity());
  image.normal.assign(pixels, glm::vec3(0));
  image.facet.assign(pixels, Image::kNoFacet);
  image.lights.assign(lamps, std::vector<std::uint32_t>(pixels, 0));
  return image;
}

Image render(int n, const VoxelMemory& voxels, const std::vector<Lamp>& lamps,
             const std::vector<facet::FacetInfo>& facets,
             const std::vector<scene::Material>& materials) {
  for (const Lamp& lamp : lamps) check_lamp(lamp, voxels);
  Image image = blank(n, lamps.size(), scene::kBackground);
  const std::size_t pixels = image.colour.size();

  std::vector<std::optional<std::size_t>> foremost(pixels);
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    auto& seen = foremost[image.pixel(voxels[i].at.x, voxels[i].at.y)];
    if (!seen || voxels[*seen].at.z < voxels[i].at.z) seen = i;
  }

  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (!foremost[pixel]) continue;
    const VoxelRecord& voxel = voxels[*foremost[pixel]];
    if (voxel.owner.facet >= facets.size() ||
        facets[voxel.owner.facet].material >= materials.size()) {
      throw Error(
          fmt::format("voxel ({},{},{}) belongs to facet {}, of which the scene knows no "
                      "normal or material: load the machine with this scene",
                      voxel.at.x, voxel.at.y, voxel.at.z, voxel.owner.facet));
    }
    const facet::FacetInfo& facet = facets[voxel.owner.facet];
    const scene::Material& material = materials[facet.material];
    const glm::vec3 normal = facet.normal.z < 0 ? -facet.normal : facet.normal;

    glm::vec3 colour = scene::own_light(material);
    for (std::size_t k = 0; k < lamps.size(); ++k) {
      const std::uint32_t arrived = lamps[k].arrived[*foremost[pixel]];
      image.lights[k][pixel] = arrived;
      if (arrived == 0) continue;
      const glm::vec3 to_lamp(lamps[k].voxel - voxel.at);
      colour += scene::thrown_back(material, normal, kTowardsViewer, glm::normalize(to_lamp)) *
                scene::faded(lamps[k].colour, glm::length(to_lamp), n);
    }
    image.colour[pixel] = colour;
    image.depth[pixel] = static_cast<float>(n) - 0.5F - static_cast<float>(voxel.at.z);
    image.normal[pixel] = normal;
    image.facet[pixel] = voxel.owner.facet;
  }
  return image;
}

}  // namespace rc2::picture
