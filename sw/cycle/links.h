// The eight neighbours of a cell (directions in rtl/rc2_pkg.sv; rtl/net/rc2_link.sv).
#pragma once

#include <array>

#include "sw/cycle/split_axis.h"

namespace rc2::cycle {

/// 0 E, 1 NE, 2 N, 3 NW, 4 W, 5 SW, 6 S, 7 SE; x grows east, y north.
constexpr unsigned kLinks = 8;

constexpr unsigned opposite(unsigned link) { return (link + 4) % kLinks; }

/// How many cells on a part goes: -1, 0 or 1.
constexpr int cells_on(Place place) { return static_cast<int>(place) - 1; }

/// The place of each neighbour along x and along y.
constexpr std::array<Place, kLinks> kPlaceX{kHigh, kHigh, kMiddle, kLow,
                                            kLow,  kLow,  kMiddle, kHigh};
constexpr std::array<Place, kLinks> kPlaceY{kMiddle, kHigh, kHigh, kHigh,
                                            kMiddle, kLow,  kLow,  kLow};

}  // namespace rc2::cycle
