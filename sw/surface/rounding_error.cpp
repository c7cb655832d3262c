#include "sw/surface/rounding_error.h"

#include <numeric>

#include "sw/facet/facet.h"
#include "sw/golden/golden_machine.h"
#include "sw/surface/winding.h"

namespace rc2::surface {
namespace {

constexpr int kFractionBits = MachineConfig{}.fraction_bits;

VoxelSet voxels_of(const facet::PacketStream& packets, int n) {
  golden::GoldenMachine machine({n, kFractionBits, 1, 1});
  machine.load(packets, {});
  VoxelSet voxels(n);
  for (const VoxelRecord& voxel : machine.read_voxels()) voxels[voxel.at] = 1;
  return voxels;
}

}  // namespace

RoundingTrial::RoundingTrial(const scene::Scene& scene, int n)
    : mesh_(quantise(scene, kFractionBits)),
      packets_(facet::build_facets(scene, n, kFractionBits, facet::Rule::armoured).packets),
      exact_(voxels_of(packets_, n)),
      voxels_(std::accumulate(exact_.begin(), exact_.end(), std::int64_t{0})) {
  if (mesh_.closed) winding_ = winding_numbers(mesh_, n);
}

RoundingError RoundingTrial::measure(int bits, Rounding rounding) const {
  const VoxelSet rounded = voxels_of(round_slabs(packets_, mesh_, bits, rounding), exact_.n());
  RoundingError error;
  auto other = rounded.begin();
  for (const int in_exact : exact_) {
    const int in_rounded = *other++;
    if (in_exact > in_rounded) ++error.missing;
    if (in_exact < in_rounded) ++error.extra;
  }
  if (winding_) error.tunnels = count_tunnels(rounded, *winding_);
  return error;
}

}  // namespace rc2::surface
