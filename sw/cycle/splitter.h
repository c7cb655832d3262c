// Splits a beam at a free voxel into its children (rtl/light/rc2_splitter.sv, rc2_extent.sv).
#pragma once

#include <cstdint>

#include "sw/cycle/links.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

/// What becomes of a beam, or of one part of V of a side beam: its remainder is served later.
struct Split {
  Beam parent;
  std::uint16_t z;            ///< the children's voxel
  Parts u, v;                 ///< all parts
  unsigned v_served;          ///< parts of V served now: all of a z beam, one of a side beam
  std::uint8_t send;          ///< links that get a child
  bool own;                   ///< a child stays in this cell
  bool more;                  ///< a remainder stays
  std::int64_t served, kept;  ///< targets served now, and those of them that stay in the cube

  /// The child for a link in `send`.
  Beam child(unsigned link) const;

  /// The child that stays in this cell, if `own`.
  Beam own_child() const { return {u.part[kMiddle], v.part[kMiddle], z, parent.dir}; }

  /// What remains of the beam, if `more`.
  Beam remainder() const;
};

Split split(const Beam& beam, int x, int y, int n, const LightJob& light);

}  // namespace rc2::cycle
