// What is written as OpenVDB is what OpenVDB reads back.
#include "sw/volume/volume.h"

#include <gtest/gtest.h>
#include <openvdb/openvdb.h>

#include <filesystem>

namespace rc2::volume {
namespace {

TEST(Volume, OpenVdbReadsBackWhatWasWritten) {
  const VoxelMemory voxels{{{0, 0, 0}, {7}}, {{3, 1, 2}, {0}}, {{15, 15, 15}, {1048575}}};
  const std::vector<LightMemory> lights{{0, 5, 9}, {2, 0, 1 << 20}};
  const std::string path = testing::TempDir() + "rc2-volume-test.vdb";
  write_vdb(path, voxels, lights);

  openvdb::initialize();
  openvdb::io::File file(path);
  file.open();
  const auto density = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("density"));
  const auto facet = openvdb::gridPtrCast<openvdb::Int32Grid>(file.readGrid("facet"));
  EXPECT_EQ(density->activeVoxelCount(), voxels.size());
  EXPECT_EQ(facet->activeVoxelCount(), voxels.size());
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const auto light =
        openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("light" + std::to_string(k)));
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      const openvdb::Coord at(voxels[i].at.x, voxels[i].at.y, voxels[i].at.z);
      EXPECT_EQ(light->tree().getValue(at), static_cast<float>(lights[k][i]));
      EXPECT_EQ(density->tree().getValue(at), 1.0F);
      EXPECT_EQ(facet->tree().getValue(at), static_cast<int>(voxels[i].owner.facet));
    }
  }
  EXPECT_EQ(density->tree().getValue({1, 0, 0}), 0.0F);
  EXPECT_EQ(facet->tree().getValue({1, 0, 0}), -1);
  // Voxel (x, y, z) is at (x, y, z) of the world.
  const openvdb::Vec3d at = density->indexToWorld(openvdb::Coord(3, 1, 2));
  EXPECT_EQ(at, openvdb::Vec3d(3, 1, 2));
  file.close();
  std::filesystem::remove(path);
}

TEST(Volume, ABadPathIsAnError) { EXPECT_THROW(write_vdb("/nowhere/volume.vdb", {}, {}), Error); }

}  // namespace
}  // namespace rc2::volume
