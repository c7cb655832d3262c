// The sets of voxels that the inside rule of the light asks for, as batches of packets.
#pragma once

#include "sw/facet/facet.h"

namespace rc2::facet {

/// As build_facets with Rule::armoured, but the packets come in batches:
///  - Layer::armour: those of build_facets;
///  - Layer::shown: the same facets by Rule::naive;
///  - Layer::guard, append_guard: of sheets, and of facets that may share a voxel with one that
///  faces
///    the opposite way; absent if there are none;
///  - Layer::inside, one batch per solid: what lies above each of its facets, see append_above. Its
///    parity is the inside of a closed mesh. A facet on the lower border of the cube has no voxel,
///    yet all voxels above: its packet has a number beyond the facets'.
/// Surfaces that are not closed, also for want of a polygon outside the cube, and rooms
/// (find_objects) have no batch; counts say how many. Nor has a solid above whose facets no voxel
/// can be.
FacetSet build_layers(const scene::Scene& scene, int n, int fraction_bits);

}  // namespace rc2::facet
