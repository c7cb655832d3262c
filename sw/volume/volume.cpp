#include "sw/volume/volume.h"

#include <fmt/format.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include <sstream>

#include "sw/base/replace_file.h"

namespace rc2::volume {
namespace {

template <typename Grid, typename Value>
openvdb::GridBase::Ptr make_grid(const std::string& name, const VoxelMemory& voxels,
                                 typename Grid::ValueType background, const Value& value) {
  const auto grid = Grid::create(background);
  grid->setName(name);
  auto accessor = grid->getAccessor();
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const glm::ivec3 at = voxels[i].at;
    accessor.setValue({at.x, at.y, at.z}, value(i));
  }
  return grid;
}

}  // namespace

void write_vdb(const std::string& path, const VoxelMemory& voxels,
               const std::vector<LightMemory>& lights) {
  openvdb::initialize();
  openvdb::GridPtrVec grids;
  const auto density =
      make_grid<openvdb::FloatGrid>("density", voxels, 0.0F, [](std::size_t) { return 1.0F; });
  density->setGridClass(openvdb::GRID_FOG_VOLUME);
  grids.push_back(density);
  grids.push_back(make_grid<openvdb::Int32Grid>("facet", voxels, -1, [&](std::size_t i) {
    return static_cast<std::int32_t>(voxels[i].owner.facet);
  }));
  for (std::size_t k = 0; k < lights.size(); ++k)
    grids.push_back(make_grid<openvdb::FloatGrid>(
        fmt::format("light{}", k), voxels, 0.0F,
        [&](std::size_t i) { return static_cast<float>(lights[k][i]); }));
  std::ostringstream bytes;
  openvdb::io::Stream(bytes).write(grids);
  replace_file(path, bytes.str());
}

}  // namespace rc2::volume
