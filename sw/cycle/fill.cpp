#include "sw/cycle/fill.h"

namespace rc2::cycle {

void Fill::step(const Span* offered, Columns& columns, std::size_t column) {
  if (writing_) columns.fill(column, written_z_, written_);
  writing_ = walking_;
  if (walking_) {
    written_z_ = span_.z0 + span_.lo;
    written_ = claim();
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
    to_seek_ = span_.lo;
    seeking_ = span_.lo != 0;
    walking_ = !seeking_;
  }
}

Claim Fill::claim() const {
  const bool core = span_.core_lo <= span_.lo && span_.lo <= span_.core_hi;
  return {span_.facet, core, gap_of(n_, span_.gap)};
}

}  // namespace rc2::cycle
