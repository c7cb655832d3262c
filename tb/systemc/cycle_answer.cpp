#include "tb/systemc/cycle_answer.h"

namespace rc2::tb {

void answer(const cycle::Columns& columns, int n, std::size_t column, ReadWhat what,
            Readback& readback) {
  const cycle::ColumnLayers& layers = columns.layers(column);
  const auto cell = static_cast<int>(column);
  for (glm::ivec3 at(cell % n, cell / n, 0); at.z < n; ++at.z) {
    const bool occupied = columns.occupied(column, at.z);
    const std::uint32_t bits =
        packed_layers({at, occupied, layers.shown.has(at.z), layers.inside.has(at.z),
                       columns.is_guard(column, at.z)});
    if (what == ReadWhat::voxels && occupied) {
      readback.add(at, columns.owner(column, at.z).claim.packed());
    }
    if (what == ReadWhat::light && occupied) readback.add(at, columns.arrived(column, at.z));
    if (what == ReadWhat::layers && bits != 0) readback.add(at, bits);
  }
}

}  // namespace rc2::tb
