#include "sw/surface/leaks.h"

#include <fmt/format.h>

#include <map>
#include <numeric>

#include "sw/base/error.h"
#include "sw/surface/mesh.h"
#include "sw/surface/winding.h"

namespace rc2::surface {
namespace {

VoxelArray<std::int32_t> inside_of(const scene::Scene& scene, int n, int f) {
  const Mesh mesh = quantise(scene, f);
  if (!mesh.closed)
    throw Error(
        fmt::format("{}: the mesh is not closed (some side has a facet on one side only, or facets "
                    "that do not turn the same way), so it has no inside; use a closed mesh",
                    scene.name));
  return winding_numbers(mesh, n);
}

}  // namespace

LeakRow find_leaks(const scene::Scene& scene, int n) {
  std::map<int, VoxelArray<std::int32_t>> inside;  // by fraction bits
  LeakRow row;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const VoxelSet voxels = discretise(scene, n, kDiscretisers[i]);
    const int f = fraction_bits(kDiscretisers[i]);
    if (inside.count(f) == 0) inside.emplace(f, inside_of(scene, n, f));
    row[i].voxels = std::accumulate(voxels.begin(), voxels.end(), std::int64_t{0});
    row[i].tunnels = count_tunnels(voxels, inside.at(f));
  }
  return row;
}

}  // namespace rc2::surface
