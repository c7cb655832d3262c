#include "sw/scene/scene.h"

namespace rc2::scene {

void Scene::add(const std::vector<glm::dvec3>& corners, std::uint32_t material_index) {
  vertices.insert(vertices.end(), corners.begin(), corners.end());
  first.push_back(static_cast<std::uint32_t>(vertices.size()));
  material.push_back(material_index);
}

}  // namespace rc2::scene
