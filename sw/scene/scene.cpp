#include "sw/scene/scene.h"

namespace rc2::scene {

void Scene::add(const std::vector<glm::dvec3>& corners, std::uint32_t material_index,
                const std::vector<glm::dvec3>& corner_normals) {
  vertices.insert(vertices.end(), corners.begin(), corners.end());
  normals.insert(normals.end(), corner_normals.begin(), corner_normals.end());
  normals.resize(vertices.size(), glm::dvec3(0));
  first.push_back(static_cast<std::uint32_t>(vertices.size()));
  material.push_back(material_index);
}

}  // namespace rc2::scene
