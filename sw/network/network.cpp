#include "sw/network/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "sw/base/error.h"
#include "sw/network/circles.h"
#include "sw/network/segments.h"

namespace rc2::network {

std::vector<std::uint8_t> draw(const Network& network, const std::vector<int>& active) {
  std::vector<std::uint8_t> lit(network.cells.size(), 0);
  for (const int drawing : active) lit.at(network.starts.at(drawing)) = 1;
  // The links are sorted by head and every tail is an earlier cell: one pass settles all.
  for (const Link& link : network.links) lit[link.to] |= lit[link.from];
  return lit;
}

Network build(Shape shape, int size, Scheme scheme) {
  if (size < 1 || size > kMaxSize) {
    throw Error(fmt::format("a network of size {} cannot be built; say 1 to {}", size, kMaxSize));
  }
  if (scheme.fan_out < 1) {
    throw Error(fmt::format("a tree of fan-out {} has no branches; say 1 or more", scheme.fan_out));
  }
  return shape == Shape::Circles ? build_circles(size, scheme) : build_segments(size, scheme);
}

Scheme scheme_of(const std::string& name) {
  if (name == "star") return {kStar};
  if (name == "chain") return {1};
  if (name == "tree") return {2};
  if (name == "nearest") return {2, false};
  const std::string prefix = "tree:";
  if (name.compare(0, prefix.size(), prefix) == 0) {
    int fan_out = 0;
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + prefix.size(), end, fan_out);
    if (read.ec == std::errc() && read.ptr == end && fan_out >= 1 && fan_out <= kStar) {
      return {fan_out};
    }
  }
  throw Error(fmt::format(
      "the scheme '{}' is not known; say star, chain, tree, nearest or tree:F with F from 1 to {}",
      name, kStar));
}

Shape shape_of(const std::string& name) {
  if (name == "circles") return Shape::Circles;
  if (name == "segments") return Shape::Segments;
  throw Error(fmt::format("the shape '{}' is not known; say circles or segments", name));
}

}  // namespace rc2::network
