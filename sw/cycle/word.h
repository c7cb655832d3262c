// A word of the loading pipe with its fields apart (rtl/rc2_pkg.sv has them packed).
#pragma once

#include <array>
#include <cstdint>

#include "sw/facet/packet.h"

namespace rc2::cycle {

enum class Kind : std::uint8_t { head, bound };

/// The fields called `lead` in rtl stand once for each pipe: [0] the cells of a row, [1] the rows.
struct Word {
  Kind kind;
  bool last;  ///< of its packet
  // HEAD
  std::uint32_t facet;
  std::int32_t z0, z_span;
  std::array<std::int32_t, 2> skip, take;
  // BOUND
  std::array<std::int64_t, 2> step;
  std::int64_t c, d;
};

inline Word head_word(const facet::PacketHead& head) {
  const glm::ivec3 span = head.hi - head.lo;
  return {Kind::head,
          false,
          head.facet,
          head.lo.z,
          span.z,
          {head.lo.x, head.lo.y},
          {span.x + 1, span.y + 1},
          {},
          0,
          0};
}

inline Word bound_word(const facet::Bound& bound, bool last) {
  return {Kind::bound, last, 0, 0, 0, {}, {}, {bound.a, bound.b}, bound.c, bound.d};
}

}  // namespace rc2::cycle
