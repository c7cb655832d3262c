#include "sw/network/measure.h"

#include <algorithm>
#include <cmath>

namespace rc2::network {

Measures measure(const Network& network) {
  Measures measures;
  const std::size_t cells = network.cells.size();
  std::vector<int> depth(cells, 0);
  std::vector<int> fan_in(cells, 0);
  std::vector<int> fan_out(cells, 0);
  for (const Link& link : network.links) {
    const glm::ivec2 way = network.cells[link.to] - network.cells[link.from];
    const double length = std::hypot(way.x, way.y);
    measures.total_length += length;
    measures.longest = std::max(measures.longest, length);
    measures.max_fan_in = std::max(measures.max_fan_in, ++fan_in[link.to]);
    measures.max_fan_out = std::max(measures.max_fan_out, ++fan_out[link.from]);
    depth[link.to] = std::max(depth[link.to], depth[link.from] + 1);
  }
  measures.cells = static_cast<int>(cells);
  measures.links = static_cast<int>(network.links.size());
  measures.depth = *std::max_element(depth.begin(), depth.end());
  const auto fed = cells - std::count(fan_in.begin(), fan_in.end(), 0);
  if (measures.links > 0) {
    measures.mean_fan_in = static_cast<double>(measures.links) / static_cast<double>(fed);
    measures.mean_length = measures.total_length / measures.links;
  }
  return measures;
}

Page page(const Network& network) {
  std::vector<Link> links = network.links;
  // By left end; of those with the same left end the longest first, which encloses the others.
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    return a.from != b.from ? a.from < b.from : a.to > b.to;
  });
  Page page;
  std::vector<int> open;  // right ends of the wires above the place where the next one begins
  for (const Link& link : links) {
    while (!open.empty() && open.back() <= link.from) open.pop_back();
    if (!open.empty() && open.back() < link.to) {
      ++page.crossed;
      continue;
    }
    open.push_back(link.to);
    page.tracks = std::max(page.tracks, static_cast<int>(open.size()));
  }
  return page;
}

}  // namespace rc2::network
