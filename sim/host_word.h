// Words as the host port of rtl/rc2_machine.sv takes them, bit for bit (rtl/rc2_pkg.sv).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "sw/base/config.h"
#include "sw/machine/word.h"

namespace rc2 {

enum class ReadWhat : std::uint8_t { voxels = 0, light = 1, counters = 2, layers = 3 };

/// Field widths of a machine's words, from its size.
struct WordFormat {
  int coordinate, count, coefficient, plane, gap, offset, side, push, lead, rest, value;

  explicit WordFormat(const MachineConfig& config)
      : coordinate(coordinate_bits(config.n)),
        count(bits_for(config.n + 1)),
        coefficient(coefficient_bits(config.n, config.fraction_bits)),
        plane(plane_bits(config.n, config.fraction_bits)),
        gap(gap_value_bits(config.n)),
        offset(offset_bits(config.n, config.fraction_bits)),
        side(side_bits(config.n, config.fraction_bits)),
        push(push_bits(config.n, config.fraction_bits)),
        lead(std::max(2 * count, coefficient)),
        rest(std::max({kLayerBits + plane + kFacetBits + 2 * coordinate, coefficient + offset,
                       kFacingBits + gap + offset, push + side + offset})),
        value(std::max(kClaimBits, home_bits(config.max_distance) + coordinate)) {}

  int packet_bits() const { return kKindBits + 2 * lead + rest; }
  int readback_bits() const { return 2 + coordinate + value; }

  /// What the machine's register of the same name holds: of a claim and of a way to face, a byte
  /// each.
  static constexpr std::uint32_t gap_and_facing() {
    return kGapFractionBits << 24 | kGapBits << 16 | kFacingBits << 8 | kOppositeFacings;
  }

  static constexpr int kKindBits = 3;
  static int home_bits(std::int64_t distance) { return bits_for(24 * distance * distance + 3); }
};

/// One beat of a packet stream: {kind, lead of the rows, lead of the cells, rest}.
class HostWord {
 public:
  static constexpr int kLimbs = 8;

  HostWord(const WordFormat& format, const Word& word) {
    fill(2 * format.lead + format.rest, WordFormat::kKindBits,
         static_cast<std::int64_t>(word.kind));
    const int cells = format.rest, rows = format.rest + format.lead;
    if (word.kind == WordKind::head) {
      fill(0, format.coordinate, word.z0);
      fill(format.coordinate, format.coordinate, word.z_span);
      fill(2 * format.coordinate, kFacetBits, word.facet);
      fill(2 * format.coordinate + kFacetBits, format.plane, word.reach);
      fill(2 * format.coordinate + kFacetBits + format.plane, kLayerBits,
           static_cast<std::int64_t>(word.layer));
      fill(cells, format.count, word.skip[0]);
      fill(cells + format.count, format.count, word.take[0]);
      fill(rows, format.count, word.skip[1]);
      fill(rows + format.count, format.count, word.take[1]);
      return;
    }
    const bool side = word.kind == WordKind::side, gap = word.kind == WordKind::gap;
    const int c_bits = side ? format.side : gap ? format.gap : format.coefficient;
    fill(0, format.offset, word.d);
    fill(format.offset, c_bits, word.c);
    if (side) fill(format.offset + c_bits, format.push, word.reach);
    if (gap) fill(format.offset + c_bits, kFacingBits, word.facing);
    fill(cells, format.coefficient, word.step[0]);
    fill(rows, format.coefficient, word.step[1]);
  }

  /// The word that asks every cell for what it holds.
  HostWord(const WordFormat& format, ReadWhat what) : HostWord(format, Word{WordKind::read}) {
    fill(0, 2, static_cast<std::int64_t>(what));
  }

  const std::array<std::uint32_t, kLimbs>& limbs() const { return limbs_; }

 private:
  // Puts the low `width` bits of the value at bit `at`, where there are zeros.
  void fill(int at, int width, std::int64_t value) {
    for (int i = 0; i < width; ++i) {
      const auto bit = static_cast<std::uint32_t>((value >> i) & 1);
      limbs_[static_cast<std::size_t>((at + i) / 32)] |= bit << ((at + i) % 32);
    }
  }

  std::array<std::uint32_t, kLimbs> limbs_{};
};

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
