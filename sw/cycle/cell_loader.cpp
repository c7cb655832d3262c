#include "sw/cycle/cell_loader.h"

namespace rc2::cycle {

bool CellLoader::ready(const Word& word) const {
  if (word.kind == WordKind::end) return !fill_.busy();
  return dexel_.ready(word, fill_.ready());
}

void CellLoader::step(const Word* word, bool taken, Columns& columns, std::size_t column) {
  const bool packet = word != nullptr && word->kind != WordKind::end;
  const Span offered = packet ? dexel_.offered(*word) : Span{};
  fill_.step(packet && taken && dexel_.offers(*word) ? &offered : nullptr, columns, column);
  if (packet) {
    dexel_.step(*word, taken);
  } else if (word != nullptr && taken) {
    columns.layers(column).end_object();
  }
}

}  // namespace rc2::cycle
