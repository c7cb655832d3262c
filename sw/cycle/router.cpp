#include "sw/cycle/router.h"

#include <algorithm>

#include "sw/cycle/cell.h"

namespace rc2::cycle {

Router::Router(int n)
    : n_(n),
      buffers_(cell_number(0, n, n)),
      slots_(buffers_.size()),
      incoming_(buffers_.size()),
      links_(buffers_.size()),
      rotate_(buffers_.size()) {
  for (unsigned link = 0; link < kLinks; ++link) {
    offset_[link] = cells_on(kPlaceY[link]) * n + cells_on(kPlaceX[link]);
  }
}

void Router::start(const LightJob& light) {
  std::fill(slots_.begin(), slots_.end(), 0);
  std::fill(incoming_.begin(), incoming_.end(), 0);
  std::fill(links_.begin(), links_.end(), 0);
  std::fill(rotate_.begin(), rotate_.end(), Rotate{});
  source_.start(light);
  source_cell_ = cell_number(light.source.x, light.source.y, n_);
}

Beam Router::take(std::size_t cell) {
  const unsigned source = has_source(cell) ? 1U << kLinks : 0U;
  const unsigned way = rotate_[cell].take(slots_[cell] | source);
  if (way == kLinks) return source_.take();
  slots_[cell] &= static_cast<std::uint8_t>(~(1U << way));
  return buffers_[cell].slot[way];
}

}  // namespace rc2::cycle
