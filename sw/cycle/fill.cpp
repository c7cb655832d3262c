#include "sw/cycle/fill.h"

namespace rc2::cycle {

void Fill::step(const Span* offered, Columns& columns, std::size_t column) {
  if (writing_) columns.fill(column, written_z_, written_facet_);
  writing_ = walking_;
  if (walking_) {
    written_z_ = span_.lo;
    written_facet_ = span_.facet;
    walking_ = span_.lo != span_.hi;
    ++span_.lo;
  } else if (offered != nullptr) {
    walking_ = true;
    span_ = *offered;
  }
}

}  // namespace rc2::cycle
