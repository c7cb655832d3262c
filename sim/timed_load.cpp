#include "sim/timed_load.h"

#include "sw/direct/voxeliser.h"
#include "sw/facet/facet.h"
#include "sw/golden/golden_machine.h"
#include "sw/golden/voxelise.h"

namespace rc2 {
namespace {

using scene::Scene;

constexpr int kFractionBits = 4;

// Every polygon as a fan of triangles.
Scene cut_to_triangles(const Scene& scene) {
  Scene triangles;
  for (std::size_t i = 0; i < scene.polygon_count(); ++i) {
    const glm::dvec3* corners = &scene.vertices[scene.first[i]];
    for (std::uint32_t k = 2; k < scene.first[i + 1] - scene.first[i]; ++k)
      triangles.add({corners[0], corners[k - 1], corners[k]}, 0);
  }
  return triangles;
}

std::int64_t count_filled(const facet::PacketStream& packets) {
  std::int64_t filled = 0;
  for (const facet::PacketHead& head : packets.heads)
    golden::for_each_dexel(
        head, packets.sides.data() + head.first_side,
        [&](const golden::Dexel& dexel) { filled += dexel.z.last - dexel.z.first + 1; });
  return filled;
}

bool same_voxels(const VoxelMemory& voxels, const direct::Voxeliser& voxeliser) {
  return static_cast<std::int64_t>(voxels.size()) == voxeliser.voxel_count() &&
         std::all_of(voxels.begin(), voxels.end(), [&](const VoxelRecord& voxel) {
           return voxeliser.owner(voxel.at) != direct::Voxeliser::kFree;
         });
}

// The packets and the machine are gone before the direct voxeliser needs room.
VoxelMemory run_golden(const Scene& scene, int n, TimedLoad& timed) {
  MachineConfig config;
  config.n = n;
  config.fraction_bits = kFractionBits;
  const facet::FacetSet facets = timed.packets.time(
      [&] { return facet::build_facets(scene, n, kFractionBits, facet::Rule::armoured); });
  golden::GoldenMachine machine(config);
  timed.load.time([&] { return machine.load(facets.packets, {}); });
  timed.facets = facets.facets.size();
  timed.filled = count_filled(facets.packets);
  return timed.list.time([&] { return machine.read_voxels(); });
}

}  // namespace

TimedLoad time_load(const std::string& name, int n, int repeats,
                    const std::function<Scene()>& make) {
  TimedLoad timed;
  timed.scene = name;
  const Scene scene = timed.import.time(make);
  const Scene triangles = cut_to_triangles(scene);
  timed.polygons = scene.polygon_count();
  timed.triangles = triangles.polygon_count();
  for (int i = 0; i < repeats; ++i) {
    const VoxelMemory voxels = run_golden(scene, n, timed);
    direct::Voxeliser voxeliser(n, kFractionBits);
    timed.direct.time([&] {
      voxeliser.fill(triangles);
      return true;
    });
    // A polygon's triangles may fill voxels at its corners that it does not fill as a whole.
    if (timed.triangles == timed.polygons) timed.agrees &= same_voxels(voxels, voxeliser);
  }
  return timed;
}

}  // namespace rc2
