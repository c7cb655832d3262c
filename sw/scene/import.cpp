#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>

#include "fmt/format.h"
#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/scene/check_header.h"
#include "sw/scene/import_lights.h"
#include "sw/scene/import_material.h"
#include "sw/scene/import_nodes.h"
#include "sw/scene/memory_guard.h"
#include "sw/scene/scene.h"

namespace rc2::scene {
namespace {

// No post-processing: triangulation would lose the polygons, the rest we do not need.
constexpr unsigned kNoPostProcessing = 0;

const aiScene& read_with_assimp(Assimp::Importer& importer, const std::string& path) {
  const aiScene* source = nullptr;
  std::string reason;
  try {
    const MemoryGuard guard;
    source = importer.ReadFile(path, kNoPostProcessing);
    reason = importer.GetErrorString();
  } catch (const std::exception& exception) {
    reason = exception.what();
  }
  if (reason.find("bad_alloc") != std::string::npos)
    reason = fmt::format("it would take more than {} bytes of memory", kImportMemory);
  // Assimp's sentences may end in a full stop or a new line; ours go on.
  reason.erase(reason.find_last_not_of(". \n") + 1);
  if (source == nullptr || source->mRootNode == nullptr)
    throw Error(
        fmt::format("{}: cannot be read as a scene: {}; check the file or export it again "
                    "in a format that Assimp reads",
                    path, reason));
  return *source;
}

// Counted before anything is copied: a mesh may be placed many times.
void check_polygon_count(const aiScene& source, const std::vector<PlacedNode>& nodes,
                         const std::string& path) {
  std::int64_t count = 0;
  for (const PlacedNode& placed : nodes)
    for (unsigned i = 0; i < placed.node->mNumMeshes; ++i)
      count += source.mMeshes[placed.node->mMeshes[i]]->mNumFaces;
  if (count > kMaxFacets)
    throw Error(
        fmt::format("{}: the scene has {} polygons but the machine numbers at most {} "
                    "facets; simplify the mesh",
                    path, count, kMaxFacets));
}

// A file's normal as the scene has it; 0 if it is no direction.
glm::dvec3 normal_of(const aiVector3D& v, const glm::dmat3& turn) {
  const glm::dvec3 normal = turn * glm::dvec3(v.x, v.y, v.z);
  const double length = glm::length(normal);
  return length > 0 && std::isfinite(length) ? normal / length : glm::dvec3(0);
}

void add_mesh(const aiMesh& mesh, const glm::dmat4& to_scene, const std::string& path,
              Scene& scene) {
  const bool mirrored = glm::determinant(glm::dmat3(to_scene)) < 0.0;
  const glm::dmat3 turn = glm::inverseTranspose(glm::dmat3(to_scene));
  std::vector<glm::dvec3> corners, normals;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices < 3) {
      ++scene.ignored_primitives;
      continue;
    }
    corners.clear();
    normals.clear();
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      const unsigned index = face.mIndices[mirrored ? face.mNumIndices - 1 - k : k];
      if (index >= mesh.mNumVertices)
        throw Error(
            fmt::format("{}: polygon {} names vertex {} of {}; the file is damaged, export "
                        "it again",
                        path, scene.polygon_count(), index, mesh.mNumVertices));
      const aiVector3D& v = mesh.mVertices[index];
      const glm::dvec3 corner = to_scene * glm::dvec4(v.x, v.y, v.z, 1.0);
      if (!std::isfinite(corner.x) || !std::isfinite(corner.y) || !std::isfinite(corner.z))
        throw Error(
            fmt::format("{}: polygon {} has a vertex that is not a finite number; repair "
                        "the mesh and export it again",
                        path, scene.polygon_count()));
      corners.push_back(corner);
      if (mesh.HasNormals()) normals.push_back(normal_of(mesh.mNormals[index], turn));
    }
    scene.add(corners, mesh.mMaterialIndex, normals);
  }
}

}  // namespace

Scene read_file(const std::string& path) {
  if (!std::filesystem::is_regular_file(path))
    throw Error(
        fmt::format("{}: there is no such file; check the path, or use a generated scene "
                    "(empty, room, gallery, ball:R, shells:PERCENT:SEED, dust:PERCENT:SEED)",
                    path));
  check_header(path);
  Assimp::Importer importer;
  const aiScene& source = read_with_assimp(importer, path);
  const aiImporterDesc* format =
      importer.GetImporterInfo(importer.GetPropertyInteger("importerIndex", -1));
  const std::vector<PlacedNode> nodes = place_nodes(
      *source.mRootNode, upright(source, format == nullptr ? "" : format->mFileExtensions));
  check_polygon_count(source, nodes, path);

  Scene scene;
  scene.name = std::filesystem::path(path).filename().string();
  for (unsigned i = 0; i < source.mNumMaterials; ++i) {
    scene.materials.push_back(import_material(*source.mMaterials[i]));
    scene.ignored_textures += texture_count(*source.mMaterials[i]);
  }
  for (const PlacedNode& placed : nodes)
    for (unsigned i = 0; i < placed.node->mNumMeshes; ++i)
      add_mesh(*source.mMeshes[placed.node->mMeshes[i]], placed.to_scene, path, scene);
  if (scene.polygon_count() == 0)
    throw Error(
        fmt::format("{}: the file has no polygon ({} points and lines); export a mesh "
                    "with faces",
                    path, scene.ignored_primitives));
  // Some formats know no materials; polygons always name one.
  if (scene.materials.empty()) scene.materials.emplace_back();
  for (std::uint32_t& material : scene.material)
    if (material >= scene.materials.size()) material = 0;
  import_lights(source, nodes, scene);
  import_camera(source, nodes, scene);
  return scene;
}

}  // namespace rc2::scene
