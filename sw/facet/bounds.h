#pragma once

#include "sw/base/config.h"
#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"

namespace rc2::facet {

/// What all facets of a job share.
struct Grid {
  int n;             ///< voxels per side
  std::int64_t one;  ///< F = 2^f, vertex units per voxel
  Rule rule;

  /// floor(value / 2F).
  std::int64_t floor_halves(std::int64_t value) const { return value >> bits_for(2 * one); }
};

/// Normal of a planar convex border (thesis 3.6: A, B, C), free of common factors of two: they
/// change no voxel, because they cancel in every bound. It fits coefficient_bits(n, f).
Vertex plane_normal(const Border& border);

/// Appends the packet of a planar convex border (thesis 3.9, "initialisation effectuee par le
/// hote"). Returns false and appends nothing if no voxel of the grid is in its box.
bool append_packet(const Border& border, const Vertex& normal, std::uint32_t facet,
                   const Grid& grid, PacketStream& stream);

/// Likewise the packet of Layer::guard: the voxels, centre within the border, that a ray could
/// reach by its step through the plane; through a sheet, its step beyond half a voxel behind the
/// plane. Along the dominant axis of the plane that is S/K voxels, and half a voxel more.
bool append_guard(const Border& border, const Vertex& normal, std::uint32_t facet, Surface surface,
                  int n, std::int64_t one, PacketStream& stream);

}  // namespace rc2::facet
