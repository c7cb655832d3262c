#pragma once

#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <vector>

namespace rc2::scene {

/// A node of the file's hierarchy and its placement in the scene.
struct PlacedNode {
  const aiNode* node;
  glm::dmat4 to_scene;
};

/// All nodes, a parent before its children. `up` is applied last.
std::vector<PlacedNode> place_nodes(const aiNode& root, const glm::dmat4& up);

/// Turns the file's up axis to y, where the format says which it is and Assimp leaves it alone.
glm::dmat4 upright(const aiScene& scene, const std::string& extensions);

}  // namespace rc2::scene
