// A word of the loading pipe with its fields apart (rtl/rc2_pkg.sv has them packed).
#pragma once

#include <array>
#include <cstdint>

#include "sw/facet/packet.h"

namespace rc2 {

/// What a word is, numbered as in rtl/rc2_pkg.sv. A packet is a HEAD, a SLAB, its SIDEs and a GAP;
/// READ, DATA and END, which ends an object, stand alone. A RAY follows a HEAD
/// (sw/machine/ray_words.h).
enum class WordKind : std::uint8_t {
  head = 0,
  slab = 1,
  side = 2,
  gap = 3,
  read = 4,
  data = 5,
  end = 6,
  ray = 7
};

/// What a RAY word says: of the facet of the HEAD before it, or of the first ray of the cell's
/// pixel.
enum class RaySort : std::uint8_t { normal = 0, shares = 1, origin = 2, direction = 3 };

/// The fields called `lead` in rtl stand once for each pipe: [0] the cells of a row, [1] the rows
/// of a feeder.
struct Word {
  WordKind kind;
  // HEAD
  facet::Layer layer = facet::Layer::armour;
  std::uint32_t facet = 0;
  std::int32_t z0 = 0, z_span = 0;
  std::array<std::int32_t, 2> skip{}, take{};
  // The others: a value at the first cell, how it steps from cell to cell and from one row of the
  // array to the next, and c of c*z + d.
  std::array<std::int64_t, 2> step{};
  std::int64_t c = 0, d = 0;
  std::int64_t reach = 0;                          ///< HEAD: width of the slab; SIDE: push
  facet::Surface surface = facet::Surface::solid;  ///< GAP
  RaySort sort = RaySort::normal;                  ///< RAY
};

}  // namespace rc2
