#include "sw/scene/import_nodes.h"

#include <string>

namespace rc2::scene {
namespace {

// Assimp stores rows, GLM columns.
glm::dmat4 matrix(const aiMatrix4x4& m) {
  return {{m.a1, m.b1, m.c1, m.d1},
          {m.a2, m.b2, m.c2, m.d2},
          {m.a3, m.b3, m.c3, m.d3},
          {m.a4, m.b4, m.c4, m.d4}};
}

const glm::dmat4 kZUpToYUp{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}};
const glm::dmat4 kXUpToYUp{{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

}  // namespace

std::vector<PlacedNode> place_nodes(const aiNode& root, const glm::dmat4& up) {
  // A list instead of recursion: the depth of a file's hierarchy is not ours to trust.
  std::vector<PlacedNode> nodes{{&root, up * matrix(root.mTransformation)}};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const PlacedNode parent = nodes[i];
    for (unsigned child = 0; child < parent.node->mNumChildren; ++child) {
      const aiNode* node = parent.node->mChildren[child];
      if (node == nullptr) continue;  // the RAW importer leaves places empty
      nodes.push_back({node, parent.to_scene * matrix(node->mTransformation)});
    }
  }
  return nodes;
}

glm::dmat4 upright(const aiScene& scene, const std::string& extensions) {
  if (extensions == "blend" || extensions == "3mf") return kZUpToYUp;
  int axis = 1;  // FBX says which axis is up; Assimp hands it on and does not turn the scene.
  if (scene.mMetaData != nullptr && scene.mMetaData->Get("UpAxis", axis)) {
    if (axis == 0) return kXUpToYUp;
    if (axis == 2) return kZUpToYUp;
  }
  return glm::dmat4(1.0);
}

}  // namespace rc2::scene
