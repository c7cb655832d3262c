#include "sw/surface/discretise.h"

#include "sw/facet/facet.h"
#include "sw/golden/golden_machine.h"
#include "sw/surface/bilinear.h"
#include "sw/surface/mesh.h"
#include "sw/surface/slices.h"

namespace rc2::surface {
namespace {

bool is_rule(Discretiser discretiser) { return discretiser <= Discretiser::blindee; }

facet::Rule rule_of(Discretiser discretiser) { return facet::parse_rule(to_string(discretiser)); }

}  // namespace

const char* to_string(Discretiser discretiser) {
  constexpr const char* kNames[] = {"armoured", "naive",    "supercover", "half",
                                    "blindee",  "bilinear", "slices"};
  return kNames[static_cast<std::size_t>(discretiser)];
}

int fraction_bits(Discretiser discretiser) {
  return is_rule(discretiser) ? MachineConfig{}.fraction_bits : 0;
}

VoxelSet discretise(const scene::Scene& scene, int n, Discretiser discretiser) {
  const int f = fraction_bits(discretiser);
  VoxelSet voxels(n);
  if (is_rule(discretiser)) {
    golden::GoldenMachine machine({n, f, 1, 1});
    machine.load(facet::build_facets(scene, n, f, rule_of(discretiser)).packets, {});
    for (const VoxelRecord& voxel : machine.read_voxels()) voxels[voxel.at] = 1;
  } else {
    const auto fill = discretiser == Discretiser::slices ? fill_slices : fill_bilinear;
    for (const facet::Border& border : quantise(scene, f).facets) fill(border, voxels);
  }
  return voxels;
}

}  // namespace rc2::surface
