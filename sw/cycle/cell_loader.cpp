#include "sw/cycle/cell_loader.h"

namespace rc2::cycle {

bool CellLoader::ready(const Word& word) const {
  if (word.kind == WordKind::end) return !fill_.busy();
  if (seeking_ > 0) return false;
  return word.kind == WordKind::ray || dexel_.ready(word, fill_.ready());
}

void CellLoader::step(const Word* word, bool taken, Columns& columns, std::size_t column) {
  step_seek(word, taken);
  const bool packet = word != nullptr && word->kind != WordKind::end && word->kind != WordKind::ray;
  const Span offered = packet ? dexel_.offered(*word) : Span{};
  fill_.step(packet && taken && dexel_.offers(*word) ? &offered : nullptr, columns, column);
  if (packet) {
    dexel_.step(*word, taken);
  } else if (word != nullptr && taken && word->kind == WordKind::end) {
    columns.layers(column).end_object();
  }
}

// Address after address, and the verdict on the last.
void CellLoader::step_seek(const Word* word, bool taken) {
  if (seeking_ > 0) {
    --seeking_;
  } else if (word != nullptr && taken && word->kind == WordKind::head) {
    z_span_ = word->z_span;
  } else if (word != nullptr && taken && word->kind == WordKind::ray &&
             word->sort == RaySort::shares) {
    seeking_ = z_span_ + 2;
  }
}

}  // namespace rc2::cycle
