#include "tb/load/lattice_polygon.h"

#include <algorithm>
#include <glm/common.hpp>

namespace rc2::facet {
namespace {

std::int64_t turn(const FlatVertex& a, const FlatVertex& b) { return a.x * b.y - a.y * b.x; }

bool is_second_half(const FlatVertex& a) { return a.y < 0 || (a.y == 0 && a.x < 0); }

// Counter-clockwise from +x.
bool comes_before(const FlatVertex& a, const FlatVertex& b) {
  if (is_second_half(a) != is_second_half(b)) return is_second_half(b);
  return turn(a, b) > 0;
}

FlatVertex random_edge(Dice& dice, std::int64_t reach) {
  FlatVertex edge(0);
  while (edge == FlatVertex(0)) edge = {dice.roll(-reach, reach), dice.roll(-reach, reach)};
  return edge;
}

// Triangles and there-and-back pairs: the edges of each add up to nothing, and so do all of them.
std::vector<FlatVertex> closed_edges(Dice& dice, int sides, std::int64_t reach) {
  std::vector<FlatVertex> edges;
  while (sides > 0) {
    const FlatVertex a = random_edge(dice, reach);
    if (sides == 3 || (sides > 4 && dice.one_in(2))) {
      const FlatVertex b = random_edge(dice, reach);
      edges.insert(edges.end(), {a, b, -a - b});
      sides -= 3;
    } else {
      edges.insert(edges.end(), {a, -a});
      sides -= 2;
    }
  }
  edges.erase(std::remove(edges.begin(), edges.end(), FlatVertex(0)), edges.end());
  return edges;
}

}  // namespace

std::vector<FlatVertex> lattice_polygon(Dice& dice, int sides, std::int64_t reach) {
  std::vector<FlatVertex> edges;
  while (edges.size() < 3) {
    const std::vector<FlatVertex> all = closed_edges(dice, sides, reach);
    edges.clear();
    std::vector<FlatVertex> sorted = all;
    std::sort(sorted.begin(), sorted.end(), comes_before);
    for (const FlatVertex& edge : sorted) {
      const bool goes_on = !edges.empty() && !comes_before(edges.back(), edge);
      if (goes_on)
        edges.back() += edge;
      else
        edges.push_back(edge);
    }
  }
  // In the order of their directions, edges that add up to nothing go once round a convex polygon.
  std::vector<FlatVertex> polygon;
  FlatVertex at(0), low(0);
  for (const FlatVertex& edge : edges) {
    polygon.push_back(at);
    at += edge;
    low = glm::min(low, at);
  }
  for (FlatVertex& vertex : polygon) vertex -= low;
  return polygon;
}

}  // namespace rc2::facet
