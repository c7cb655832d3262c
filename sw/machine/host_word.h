// Words as the host port of rtl/rc2_machine.sv takes them, bit for bit (rtl/rc2_pkg.sv).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>

#include "sw/base/config.h"
#include "sw/machine/plane.h"
#include "sw/machine/word.h"
#include "sw/rays/format.h"

namespace rc2 {

enum class ReadWhat : std::uint8_t {
  voxels = 0,
  light = 1,
  counters = 2,
  layers = 3,
  ends = 4,
  hits = 5
};

/// Field widths of a machine's words, from its size.
struct WordFormat {
  int coordinate, count, coefficient, width, gap, normal, offset, side, push, lead, rest, value;

  explicit WordFormat(const MachineConfig& config)
      : coordinate(coordinate_bits(config.n)),
        count(bits_for(config.n + 1)),
        coefficient(coefficient_bits(config.n, config.fraction_bits)),
        width(width_bits(config.n, config.fraction_bits)),
        gap(gap_value_bits(config.n)),
        normal(normal_bits(config.n)),
        offset(offset_bits(config.n, config.fraction_bits)),
        side(side_bits(config.n, config.fraction_bits)),
        push(push_bits(config.n, config.fraction_bits)),
        lead(std::max(2 * count, coefficient)),
        rest(std::max({kLayerBits + width + kFacetBits + 2 * coordinate, coefficient + offset,
                       kSurfaceBits + normal + gap + offset, push + side + offset,
                       config.ray_depth > 0 ? kSortBits + ray_bits(config.n) : 0})),
        value(std::max(kClaimBits, home_bits(config.max_distance) + coordinate)) {}

  int packet_bits() const { return kKindBits + 2 * lead + rest; }
  int readback_bits() const { return 2 + coordinate + value; }

  /// What the machine's register of the same name holds: fraction bits and bits of a gap and of a
  /// component of a normal, a byte each.
  static constexpr std::uint32_t gap_and_normal(int n) {
    return static_cast<std::uint32_t>(kGapFractionBits << 24 | kGapBits << 16 |
                                      normal_fraction_bits(n) << 8 | normal_bits(n));
  }

  /// Bits of what a RAY word says: a place, or the shares and indices of a facet.
  static constexpr int ray_bits(int n) { return std::max(3 * rays::place_bits(n), 48); }

  static constexpr int kKindBits = 3;
  static constexpr int kSortBits = 2;
  static int home_bits(std::int64_t distance) { return bits_for(24 * distance * distance + 3); }
};

/// A field of a word.
struct Field {
  std::int64_t value;
  int width;
};

/// How many leads a word still carries: a row pipe's lacks that of the rows.
enum class Leads : std::uint8_t { cells = 1, rows_and_cells = 2 };

/// One beat of a packet stream: {kind, lead of the rows, lead of the cells, rest}.
class HostWord {
 public:
  static constexpr int kLimbs = 8;
  using Limbs = std::array<std::uint32_t, kLimbs>;

  HostWord(const WordFormat& format, const Word& word, Leads leads = Leads::rows_and_cells) {
    const int cells = format.rest, rows = format.rest + format.lead;
    fill(format.rest + static_cast<int>(leads) * format.lead, WordFormat::kKindBits,
         static_cast<std::int64_t>(word.kind));
    const bool with_rows = leads == Leads::rows_and_cells;
    if (word.kind == WordKind::head) {
      fill(0, format.coordinate, word.z0);
      fill(format.coordinate, format.coordinate, word.z_span);
      fill(2 * format.coordinate, kFacetBits, word.facet);
      fill(2 * format.coordinate + kFacetBits, format.width, word.reach);
      fill(2 * format.coordinate + kFacetBits + format.width, kLayerBits,
           static_cast<std::int64_t>(word.layer));
      fill(cells, format.count, word.skip[0]);
      fill(cells + format.count, format.count, word.take[0]);
      if (with_rows) {
        fill(rows, format.count, word.skip[1]);
        fill(rows + format.count, format.count, word.take[1]);
      }
      return;
    }
    const bool side = word.kind == WordKind::side, gap = word.kind == WordKind::gap;
    const int c_bits = side ? format.side : gap ? format.gap : format.coefficient;
    fill(0, format.offset, word.d);
    fill(format.offset, c_bits, word.c);
    if (side) fill(format.offset + c_bits, format.push, word.reach);
    if (gap) {
      const int after = format.offset + c_bits;
      fill(after, format.normal, normal_part(word.step[1]));
      fill(after + format.normal, kSurfaceBits, static_cast<std::int64_t>(word.surface));
    }
    fill(cells, format.coefficient, word.step[0]);
    if (with_rows) fill(rows, format.coefficient, word.step[1]);
  }

  /// The word that asks every cell for what it holds.
  HostWord(const WordFormat& format, ReadWhat what, Leads leads = Leads::rows_and_cells)
      : HostWord(format, read_word(what), leads) {}

  /// A RAY word, its fields from the lowest.
  HostWord(const WordFormat& format, RaySort sort, std::initializer_list<Field> fields) {
    int at = 0;
    for (const Field& field : fields) {
      fill(at, field.width, field.value);
      at += field.width;
    }
    fill(format.rest - WordFormat::kSortBits, WordFormat::kSortBits,
         static_cast<std::int64_t>(sort));
    fill(format.rest + 2 * format.lead, WordFormat::kKindBits,
         static_cast<std::int64_t>(WordKind::ray));
  }

  const Limbs& limbs() const { return limbs_; }

 private:
  // What a READ asks for lies where other words have d.
  static Word read_word(ReadWhat what) {
    Word word{WordKind::read};
    word.d = static_cast<std::int64_t>(what);
    return word;
  }

  // Puts the low `width` bits of the value at bit `at`, where there are zeros.
  void fill(int at, int width, std::int64_t value) {
    for (int i = 0; i < width; ++i) {
      const auto bit = static_cast<std::uint32_t>((value >> i) & 1);
      limbs_[static_cast<std::size_t>((at + i) / 32)] |= bit << ((at + i) % 32);
    }
  }

  Limbs limbs_{};
};

/// The word of a beat; that of a READ holds in d what it asks for (ReadWhat).
inline Word unpack_word(const WordFormat& format, const HostWord::Limbs& limbs,
                        Leads leads = Leads::rows_and_cells) {
  const auto field = [&](int at, int width) {
    std::int64_t value = 0;
    for (int i = 0; i < width; ++i) {
      const auto bit = limbs[static_cast<std::size_t>((at + i) / 32)] >> ((at + i) % 32) & 1U;
      value |= static_cast<std::int64_t>(bit) << i;
    }
    return value;
  };
  const auto number = [&](int at, int width) {
    return static_cast<std::int32_t>(field(at, width));
  };
  const auto with_sign = [&](int at, int width) {
    const std::int64_t value = field(at, width);
    return value - (value >> (width - 1) << width);
  };
  Word word{static_cast<WordKind>(
      field(format.rest + static_cast<int>(leads) * format.lead, WordFormat::kKindBits))};
  const auto pipes = static_cast<std::size_t>(leads);
  if (word.kind == WordKind::head) {
    word.z0 = number(0, format.coordinate);
    word.z_span = number(format.coordinate, format.coordinate);
    word.facet = static_cast<std::uint32_t>(field(2 * format.coordinate, kFacetBits));
    word.reach = field(2 * format.coordinate + kFacetBits, format.width);
    word.layer = static_cast<facet::Layer>(
        field(2 * format.coordinate + kFacetBits + format.width, kLayerBits));
    for (std::size_t pipe = 0; pipe < pipes; ++pipe) {
      const int lead = format.rest + static_cast<int>(pipe) * format.lead;
      word.skip[pipe] = number(lead, format.count);
      word.take[pipe] = number(lead + format.count, format.count);
    }
    return word;
  }
  const bool side = word.kind == WordKind::side, gap = word.kind == WordKind::gap;
  const int c_bits = side ? format.side : gap ? format.gap : format.coefficient;
  word.d = with_sign(0, format.offset);
  word.c = with_sign(format.offset, c_bits);
  if (side) word.reach = field(format.offset + c_bits, format.push);
  if (gap) {
    word.surface =
        static_cast<facet::Surface>(field(format.offset + c_bits + format.normal, kSurfaceBits));
    // Who has no lead of the rows knows b as it is in the normal.
    word.step[1] = with_sign(format.offset + c_bits, format.normal) * 4;
  }
  for (std::size_t pipe = 0; pipe < pipes; ++pipe) {
    word.step[pipe] =
        with_sign(format.rest + static_cast<int>(pipe) * format.lead, format.coefficient);
  }
  return word;
}

/// One beat of the readback stream.
struct ReadbackWord {
  bool last_of_cell, empty;
  int z;
  std::uint32_t value;
};

inline std::uint64_t pack_readback(const WordFormat& format, const ReadbackWord& word) {
  return std::uint64_t{word.last_of_cell} << (format.readback_bits() - 1) |
         std::uint64_t{word.empty} << (format.readback_bits() - 2) |
         static_cast<std::uint64_t>(word.z) << format.value | word.value;
}

inline ReadbackWord unpack_readback(const WordFormat& format, std::uint64_t beat) {
  const auto field = [&](int at, int width) { return (beat >> at) & ((1ULL << width) - 1); };
  return {field(format.readback_bits() - 1, 1) != 0, field(format.readback_bits() - 2, 1) != 0,
          static_cast<int>(field(format.value, format.coordinate)),
          static_cast<std::uint32_t>(field(0, format.value))};
}

}  // namespace rc2
