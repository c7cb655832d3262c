// Which rays pass which surfaces: the tables of figures 2.9 and 2.11.
#pragma once

#include <array>
#include <optional>

#include "sw/lines/neighbourhood.h"

namespace rc2::lines {

/// Surfaces of one kind met by rays of one connectivity.
template <class Surface>
struct Encounter {
  std::int64_t surfaces = 0, leaking = 0;
  std::optional<Surface> smallest;  ///< the smallest surface that leaks
};

/// By index_of() the rays' connectivity, then the kind of surface.
template <class Surface>
using TunnelTable = std::array<std::array<Encounter<Surface>, 3>, 3>;

}  // namespace rc2::lines
