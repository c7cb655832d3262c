// One cell of the thesis (rtl/rc2_cell_thesis.sv) with its loading and its light, as RTL and as
// cycle model: row pipe, eight links, and what the array around it tells it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "sw/machine/host_word.h"
#include "sw/machine/machine.h"
#include "tb/systemc/unit.h"

namespace rc2::tb {

constexpr MachineConfig kArray{RC2_N, 4, 4 * RC2_N, 32, 2, true};
constexpr std::size_t kLinks = 8;  // 0 E, 1 NE, 2 N, 3 NW, 4 W, 5 SW, 6 S, 7 SE

/// Numbers of the streams. Link d is input kLinkIn + d and output kLinkOut + d.
enum CellIn : std::size_t { kCommandIn, kWordsIn, kLinkIn };
enum CellOut : std::size_t { kWordsOut, kLinkOut, kHomeOut = kLinkOut + kLinks };

/// Commands; words of the row pipe in and out; beams in and out; numbers of targets that end their
/// way in this cell, none of them 0.
StreamNames cell_streams();

/// A cell with a neighbour on each side, and the same for the same seed.
glm::ivec2 chosen_cell(std::uint64_t seed);

/// What the array tells all its cells.
struct CellCommand {
  bool clear, start;
  LightJob light;
};
Beat pack_command(const CellCommand& command);
CellCommand unpack_command(const Beat& beat);

/// A beam as beam_t of rtl/rc2_pkg.sv.
struct LinkBeam {
  int dir, z, u_min, u_max, v_min, v_max;

  std::int64_t targets() const {
    return std::int64_t{u_max - u_min + 1} * std::int64_t{v_max - v_min + 1};
  }
};
Beat pack_beam(const LinkBeam& beam);
LinkBeam unpack_beam(const Beat& beat);

/// A word of readback on the row pipe.
Beat pack_data(std::uint64_t readback);

std::unique_ptr<Unit> make_rtl_cell(glm::ivec2 cell, const std::string& waves);
std::unique_ptr<Unit> make_cycle_cell(glm::ivec2 cell);

}  // namespace rc2::tb
