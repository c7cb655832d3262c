#include "sw/peers/mesh_volume.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <glm/common.hpp>
#include <tuple>

namespace rc2::peers {

std::vector<glm::ivec3> mesh_to_voxels(const truth::Triangles& triangles, int n, double distance) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  openvdb::initialize();
  std::vector<openvdb::Vec3s> points;
  points.reserve(triangles.vertices.size());
  for (const glm::dvec3& v : triangles.vertices)
    points.emplace_back(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
  std::vector<openvdb::Vec3I> corners;
  corners.reserve(triangles.corners.size());
  for (const glm::uvec3& t : triangles.corners) corners.emplace_back(t.x, t.y, t.z);
  constexpr float kBand = 1;
  const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
  const auto grid = openvdb::tools::meshToUnsignedDistanceField<openvdb::FloatGrid>(
      *transform, points, corners, {}, kBand);
  std::vector<glm::ivec3> voxels;
  for (auto value = grid->cbeginValueOn(); value; ++value) {
    if (static_cast<double>(value.getValue()) > distance) continue;
    const openvdb::Coord at = value.getCoord();
    const glm::ivec3 voxel(at.x(), at.y(), at.z());
    if (glm::clamp(voxel, 0, n - 1) == voxel) voxels.push_back(voxel);
  }
  std::sort(voxels.begin(), voxels.end(), [](const glm::ivec3& a, const glm::ivec3& b) {
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
  });
  return voxels;
}

}  // namespace rc2::peers
