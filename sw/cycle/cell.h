// How cells, and their columns, are numbered.
#pragma once

#include <cstddef>

namespace rc2::cycle {

/// Row by row: y*n + x.
inline std::size_t cell_number(int x, int y, int n) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(n) + static_cast<std::size_t>(x);
}

}  // namespace rc2::cycle
