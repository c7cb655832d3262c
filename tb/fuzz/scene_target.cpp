// Any polygons whatever through the whole path: facets, packets, voxels, light. What is refused is
// refused with an Error; everything else has to load, and what is loaded is judged by laws, by a
// second machine and by the polygons themselves.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>
#include <vector>

#include "sw/cycle/cycle_machine.h"
#include "sw/facet/layers.h"
#include "sw/golden/golden_machine.h"
#include "sw/machine/checks.h"
#include "sw/report/laws.h"
#include "sw/surface/mesh.h"
#include "sw/surface/voxel_array.h"
#include "tb/fuzz/bytes.h"

namespace rc2::tb {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

// Places in the cube, many on voxel borders and lattice points, where rounding can go wrong; of
// wild scenes also outside it, and any numbers, infinity and NaN among them.
glm::dvec3 place(Bytes& bytes, int n, bool wild, const std::vector<glm::dvec3>& earlier) {
  const std::size_t kind = bytes.below(wild ? 16 : 14);
  if (kind < 6 && !earlier.empty())
    return earlier[bytes.below(std::min<std::size_t>(earlier.size(), 256))];
  glm::dvec3 at;
  for (int axis = 0; axis < 3; ++axis) {
    const double share = bytes.word() / 65535.0;
    if (kind < 12) {
      at[axis] = share * (n - 1);
    } else if (kind == 12) {
      at[axis] = std::floor(share * 2 * (n - 1)) / 2;
    } else if (kind == 13) {
      at[axis] = (n - 1) / 2.0 + (share - 0.5) * 1e-9;
    } else if (kind == 14) {
      at[axis] = (3 * share - 1) * n;
    } else {
      at[axis] = bytes.real();
    }
  }
  return at;
}

scene::Scene make_scene(Bytes& bytes, int n) {
  scene::Scene scene;
  scene.name = "fuzz";
  scene.materials.resize(1);
  const bool wild = bytes.below(4) == 0;
  std::vector<glm::dvec3> corners;
  while (!bytes.empty() && scene.polygon_count() < 64) {
    corners.clear();
    const std::size_t count = 3 + bytes.below(4);
    for (std::size_t i = 0; i < count; ++i) {
      corners.push_back(place(bytes, n, wild, scene.vertices));
    }
    scene.add(corners, 0);
  }
  return scene;
}

// The middle of each facet in the cube lies in a voxel that is occupied, or on the border of one.
void check_covered(const VoxelMemory& voxels, const scene::Scene& scene, int n, int fraction_bits) {
  surface::VoxelSet occupied(n);
  for (const VoxelRecord& voxel : voxels) occupied[voxel.at] = 1;
  for (const facet::Border& border : surface::quantise(scene, fraction_bits).facets) {
    glm::dvec3 middle(0);
    for (const facet::Vertex& vertex : border) middle += glm::dvec3(vertex);
    middle /= std::ldexp(static_cast<double>(border.size()), fraction_bits);
    if (glm::clamp(middle, -0.5, n - 0.5) == middle)
      require(surface::covers(occupied, middle, 1e-6), "the middle of a facet is in no voxel");
  }
}

void check_light(golden::GoldenMachine& golden, cycle::CycleMachine& cycle, const LightJob& job,
                 std::size_t voxels) {
  const LightResult expected = golden.light(job, {});
  const LightResult result = cycle.light(job, {});
  const LightMemory memory = cycle.read_light();
  require(golden.read_light() == memory, "the machines light differently");
  report::check_light(expected, golden.read_light(), job, voxels);
  report::check_light(result, memory, job, voxels);
}

void try_scene(Bytes& bytes) {
  MachineConfig config;
  config.n = 2 + static_cast<int>(bytes.below(12));
  config.fraction_bits = static_cast<int>(bytes.below(9));
  config.max_distance = 4 * config.n;
  config.max_fa = 8;
  const LightJob job{
      {static_cast<int>(bytes.below(config.n)), static_cast<int>(bytes.below(config.n)),
       static_cast<int>(bytes.below(config.n))},
      1 + static_cast<int>(bytes.below(config.max_distance)),
      1 + static_cast<int>(bytes.below(8)),
      bytes.below(2) == 0 ? LightRule::accurate : LightRule::thesis};
  const scene::Scene scene = make_scene(bytes, config.n);
  facet::FacetSet set;
  try {
    set = facet::build_layers(scene, config.n, config.fraction_bits);
  } catch (const Error&) {
    return;
  }
  try {
    check_packets(config, set.packets);
  } catch (const Error& error) {
    throw std::logic_error(error.what());
  }
  golden::GoldenMachine golden(config);
  cycle::CycleMachine cycle(config);
  golden.load(set.packets, {});
  cycle.load(set.packets, {});
  const VoxelMemory voxels = golden.read_voxels();
  require(voxels == cycle.read_voxels(), "the machines hold different voxels");
  require(golden.read_layers() == cycle.read_layers(), "the machines hold different layers");
  report::check_voxels(voxels, config.n, set.facets.size());
  check_covered(voxels, scene, config.n, config.fraction_bits);
  const bool is_free = std::none_of(voxels.begin(), voxels.end(), [&](const VoxelRecord& voxel) {
    return voxel.at == job.source;
  });
  if (is_free) check_light(golden, cycle, job, voxels.size());
}

}  // namespace
}  // namespace rc2::tb

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rc2::tb::Bytes bytes(data, size);
  rc2::tb::try_scene(bytes);
  return 0;
}
