// Packet words as the host port of rtl/rc2_machine.sv takes them, bit for bit (rtl/rc2_pkg.sv).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "sw/base/config.h"
#include "sw/facet/packet.h"

namespace rc2 {

enum class WordKind : std::uint8_t { head = 0, bound = 1, read = 2, data = 3 };
enum class ReadWhat : std::uint8_t { voxels = 0, light = 1, counters = 2 };

/// Field widths of a machine's words, from its size.
struct WordFormat {
  int coordinate, count, coefficient, offset, lead, rest, value;

  explicit WordFormat(const MachineConfig& config)
      : coordinate(coordinate_bits(config.n)),
        count(bits_for(config.n + 1)),
        coefficient(coefficient_bits(config.n, config.fraction_bits)),
        offset(offset_bits(config.n, config.fraction_bits)),
        lead(std::max(2 * count, coefficient)),
        rest(std::max(kFacetBits + 2 * coordinate, coefficient + offset)),
        value(std::max(kFacetBits, home_bits(config.max_distance) + coordinate)) {}

  int packet_bits() const { return 2 + 2 * lead + rest; }
  int readback_bits() const { return 2 + coordinate + value; }

  static int home_bits(std::int64_t distance) { return bits_for(24 * distance * distance + 3); }
};

/// One beat of the packet stream: {kind, lead of the rows, lead of the cells, rest}.
class HostWord {
 public:
  static constexpr int kLimbs = 8;

  HostWord(const WordFormat& format, WordKind kind, bool last) : last_(last) {
    put(2 * format.lead + format.rest, 2, static_cast<std::uint64_t>(kind));
  }

  bool last() const { return last_; }
  const std::array<std::uint32_t, kLimbs>& limbs() const { return limbs_; }

  /// Writes the low `width` (<= 64) bits of value at bit `at`; those bits must be 0.
  void put(int at, int width, std::uint64_t value) {
    for (int i = 0; i < width; ++i) {
      const auto bit = static_cast<std::uint32_t>((value >> i) & 1U);
      limbs_[static_cast<std::size_t>((at + i) / 32)] |= bit << ((at + i) % 32);
    }
  }

 private:
  std::array<std::uint32_t, kLimbs> limbs_{};
  bool last_;
};

inline HostWord head_word(const WordFormat& format, const facet::PacketHead& head) {
  HostWord word(format, WordKind::head, false);
  const auto span = [&](int axis) {
    return static_cast<std::uint64_t>(head.hi[axis] - head.lo[axis]);
  };
  const auto low = [&](int axis) { return static_cast<std::uint64_t>(head.lo[axis]); };
  word.put(0, format.coordinate, low(2));
  word.put(format.coordinate, format.coordinate, span(2));
  word.put(2 * format.coordinate, kFacetBits, head.facet);
  for (int axis = 0; axis < 2; ++axis) {  // x steers the cells, y the rows
    const int lead = format.rest + axis * format.lead;
    word.put(lead, format.count, low(axis));
    word.put(lead + format.count, format.count, span(axis) + 1);
  }
  return word;
}

inline HostWord bound_word(const WordFormat& format, const facet::Bound& bound, bool last) {
  HostWord word(format, WordKind::bound, last);
  word.put(0, format.offset, static_cast<std::uint64_t>(bound.d));
  word.put(format.offset, format.coefficient, static_cast<std::uint64_t>(bound.c));
  word.put(format.rest, format.coefficient, static_cast<std::uint64_t>(bound.a));
  word.put(format.rest + format.lead, format.coefficient, static_cast<std::uint64_t>(bound.b));
  return word;
}

inline HostWord read_word(const WordFormat& format, ReadWhat what) {
  HostWord word(format, WordKind::read, true);
  word.put(0, 2, static_cast<std::uint64_t>(what));
  return word;
}

/// One beat of the readback stream.
struct ReadbackWord {
  bool last_of_cell, empty;
  int z;
  std::uint32_t value;
};

inline ReadbackWord unpack_readback(const WordFormat& format, std::uint64_t beat) {
  const auto field = [&](int at, int width) { return (beat >> at) & ((1ULL << width) - 1); };
  return {field(format.readback_bits() - 1, 1) != 0, field(format.readback_bits() - 2, 1) != 0,
          static_cast<int>(field(format.value, format.coordinate)),
          static_cast<std::uint32_t>(field(0, format.value))};
}

}  // namespace rc2
