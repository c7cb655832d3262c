// Slabs whose coefficients have few bits: an experiment on what the machine's exact ones are worth.
//
// With K the largest of |A|, |B|, |C| and M = 2^(W-1) - 1 the largest coefficient of W bits, the
// normal N becomes N' = N M / K to the nearest integers. What that changes, r = K N' - M N, is zero
// along the dominant axis and at most K / 2 along the others. Since K N'.q = M N.q + r.q, a voxel q
// of the exact slab, N.q + back >= 0 and front - N.q >= 0, meets
//   K N'.q >= -M back + r.q   and   K N'.q <= M front + r.q.
// A rounded slab has to put something in place of r.q. Its value at one point makes both planes
// meet there. Its least value in the first line and its greatest in the second, over the packet's
// box, make the rounded slab contain the exact one; and a superset of voxels that stop all rays
// stops all rays. They differ by the sum over the axes of |r| (hi - lo), so where 0 <= value < S is
// the exact slab, the widened one has
//   width <= S' + 1 + half the sum of hi - lo along the two axes that are not dominant,
// the 1 for rounding S. Sides, boxes and claims stay exact.
#pragma once

#include <array>

#include "sw/facet/packet.h"
#include "sw/surface/mesh.h"

namespace rc2::surface {

/// What is put in place of r.q.
enum class Rounding {
  origin,    ///< r.q at voxel (0,0,0): A, B, C, D are scaled and rounded, each for itself
  centroid,  ///< r.q at the mean of the facet's vertices: D is computed anew from A, B, C
  widened    ///< least and greatest r.q in the packet's box: no voxel gets lost
};

constexpr std::array<Rounding, 3> kRoundings = {Rounding::origin, Rounding::centroid,
                                                Rounding::widened};

const char* to_string(Rounding rounding);

/// The packets with slabs of W = `bits` bits, sign included, 2 .. 62. Slabs that fit stay as they
/// are; from plane_bits(n, f) on all do. Facet k of `mesh` is the facet of packet number k; only
/// for the centroid is it looked at. Every machine for the n and f of the exact packets takes the
/// result.
facet::PacketStream round_slabs(const facet::PacketStream& exact, const Mesh& mesh, int bits,
                                Rounding rounding);

}  // namespace rc2::surface
