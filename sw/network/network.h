// A Boolean network that draws (thesis 2.4): one cell a pixel, its output the OR of its inputs.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace rc2::network {

constexpr int kMaxSize = 1024;  ///< largest R or N a network is built for

/// A wire from the output of one cell to an input of another (both are cell numbers).
struct Link {
  int from, to;
};

/// What 2.4.2 calls moving the wrong links; all zero for circles, which share no pixel.
struct Repair {
  int planned = 0;    ///< links of the plain scheme
  int wrong = 0;      ///< of these, links whose tail is on a segment that misses the head
  int threshold = 0;  ///< most columns a tail was moved by
};

struct Network {
  int size = 0;                   ///< R or N: drawings are numbered 0 .. size
  std::vector<glm::ivec2> cells;  ///< their pixels, first octant; a link goes to a later cell
  std::vector<int> starts;        ///< drawing k appears when cell starts[k] is switched on
  std::vector<Link> links;        ///< sorted by head, then tail; no link twice
  Repair repair;
};

/// The output of every cell once the starts of the drawings `active` are on. Any number of drawings
/// at once; the result is then the union of each alone.
std::vector<std::uint8_t> draw(const Network& network, const std::vector<int>& active);

/// The two families of drawings: all circles of radius 0 .. R about the origin, or all segments
/// from the origin to the pixels (N, 0) .. (N, N).
enum class Shape { Circles, Segments };

/// How a network is wired.
struct Scheme {
  int fan_out;             ///< of the tree planned along each drawing; 1 is the thesis's chain
  bool keep_depth = true;  ///< a moved link may not put a cell deeper than its place in the tree
};
constexpr int kStar = 2 * kMaxSize;  ///< the fan-out that hangs every pixel from the start itself

/// Builds the network of every drawing of a family. Throws Error unless 1 <= size <= kMaxSize and
/// the fan-out is at least 1.
Network build(Shape shape, int size, Scheme scheme);

/// The schemes by name: "star" (all from one), "chain", "tree" (binary), "tree:F", and "nearest", a
/// binary tree without keep_depth: the rule of 2.4.2 to the letter. Throws Error on anything else.
Scheme scheme_of(const std::string& name);

/// "circles" or "segments". Throws Error on anything else.
Shape shape_of(const std::string& name);

}  // namespace rc2::network
