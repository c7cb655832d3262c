#pragma once

#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"

namespace rc2::facet {

/// What all facets of a job share.
struct Grid {
  int n;             ///< voxels per side
  std::int64_t one;  ///< F = 2^f, vertex units per voxel
  Rule rule;
};

/// Normal of a planar convex border (thesis 3.6: A, B, C), free of common factors of two: without
/// them it fits coefficient_bits(n, f), one case excepted (see fits_coefficients).
/// A common factor changes no voxel, because it cancels in every bound.
Vertex plane_normal(const Border& border);

/// False only for a facet that covers exactly half of a face of the cube, seen from there, with n
/// a power of two: one coefficient may then be 2^(2(log2 n + f)) itself.
bool fits_coefficients(const Vertex& normal, int n, int fraction_bits);

/// Appends the packet of a planar convex border (thesis 3.9, "initialisation effectuee par le
/// hote"). Returns false and appends nothing if no voxel of the grid is in its box.
bool append_packet(const Border& border, const Vertex& normal, std::uint32_t facet,
                   const Grid& grid, PacketStream& stream);

}  // namespace rc2::facet
