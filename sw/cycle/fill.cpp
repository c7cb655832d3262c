#include "sw/cycle/fill.h"

namespace rc2::cycle {

void Fill::step(const Span* offered, Columns& columns, std::size_t column) {
  if (writing_) write(columns, column);
  writing_ = walking_;
  if (walking_) {
    written_z_ = span_.z0 + span_.lo;
    written_ = owner();
    written_layer_ = span_.layer;
    walking_ = span_.lo != span_.hi;
    ++span_.lo;
    span_.gap += span_.gap_step;
  } else if (seeking_) {
    // The unit adds up gap_step * lo bit by bit, from the lowest.
    to_seek_ /= 2;
    if (to_seek_ == 0) {
      span_.gap += span_.gap_step * span_.lo;
      seeking_ = false;
      walking_ = true;
    }
  } else if (offered != nullptr) {
    span_ = *offered;
    if (span_.layer == facet::Layer::inside) span_.hi = span_.lo;  // one step flips all above
    to_seek_ = span_.lo;
    const bool claims = span_.layer == facet::Layer::armour || span_.layer == facet::Layer::guard;
    seeking_ = span_.lo != 0 && claims;
    walking_ = !seeking_;
  }
}

void Fill::write(Columns& columns, std::size_t column) const {
  switch (written_layer_) {
    case facet::Layer::armour:
      columns.fill(column, written_z_, written_);
      break;
    case facet::Layer::shown:
      columns.layers(column).shown.set(written_z_);
      break;
    case facet::Layer::inside:
      columns.layers(column).flip_from(written_z_);
      break;
    case facet::Layer::guard:
      columns.guard(column, written_z_, written_);
      break;
  }
}

Owner Fill::owner() const {
  const bool core = span_.core_lo <= span_.lo && span_.lo <= span_.core_hi;
  return {{span_.facet, core, gap_of(n_, span_.gap)}, span_.normal, span_.surface};
}

}  // namespace rc2::cycle
