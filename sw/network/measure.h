// What the thesis claims of its networks, measured.
#pragma once

#include <cstdint>

#include "sw/network/network.h"

namespace rc2::network {

/// Lengths are Euclidean, in pixels, from centre to centre.
struct Measures {
  int cells = 0;
  int links = 0;
  int depth = 0;  ///< most links between a start and a cell: gates to pass once the start is on
  int max_fan_in = 0;
  int max_fan_out = 0;
  double mean_fan_in = 0;  ///< links per cell that has any at its input
  double total_length = 0;
  double longest = 0;
  double mean_length = 0;
};
Measures measure(const Network& network);

/// The wires drawn as straight lines between pixel centres: pairs that disturb each other, found in
/// exact integers. All zero means that this drawing is planar.
struct Disturbances {
  std::int64_t crossings = 0;  ///< inner points cross
  std::int64_t overlaps = 0;   ///< on one line, with more than a point in common
  std::int64_t through = 0;    ///< one ends inside the other: a wire across a foreign cell
  bool none() const { return crossings + overlaps + through == 0; }
};
Disturbances straight_wires(const Network& network);

/// The wires drawn on one side of the line of cells in the order of their numbers, as on the page
/// of a book with the cells along its spine. Two wires cross there when exactly one end of the one
/// lies strictly between the ends of the other.
struct Page {
  std::int64_t crossed = 0;  ///< links that cross one to their left; none means a planar drawing
  int tracks = 0;            ///< most wires above one another, if none is crossed
};
Page page(const Network& network);

}  // namespace rc2::network
