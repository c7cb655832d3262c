#include "sw/facet/polygon.h"

#include <cstdlib>

namespace rc2::facet {
namespace {

bool is_collinear(const Vertex& a, const Vertex& b, const Vertex& c) {
  return cross(b - a, c - b) == Vertex(0);
}

// Which half turn a direction lies in; a convex border changes it twice.
bool is_second_half(std::int64_t u, std::int64_t v) { return v < 0 || (v == 0 && u < 0); }

}  // namespace

int dominant_axis(const Vertex& normal) {
  int axis = 2;
  if (std::abs(normal.y) > std::abs(normal[axis])) axis = 1;
  if (std::abs(normal.x) > std::abs(normal[axis])) axis = 0;
  return axis;
}

void clean(Border& border) {
  if (border.size() == 3 && !is_collinear(border[0], border[1], border[2])) return;
  std::size_t kept = 0;
  for (const Vertex& vertex : border) {
    while (kept >= 2 && is_collinear(border[kept - 2], border[kept - 1], vertex)) --kept;
    if (kept == 1 && border[0] == vertex) continue;
    border[kept++] = vertex;
  }
  border.resize(kept);
  // Where the border closes, both its ends may still be superfluous.
  std::size_t start = 0;
  while (kept - start >= 3) {
    if (is_collinear(border[kept - 2], border[kept - 1], border[start]))
      --kept;
    else if (is_collinear(border[kept - 1], border[start], border[start + 1]))
      ++start;
    else
      break;
  }
  border.resize(kept);
  border.erase(border.begin(), border.begin() + static_cast<std::ptrdiff_t>(start));
}

Vertex doubled_area(const Border& border) {
  Vertex sum(0);
  for (std::size_t i = 2; i < border.size(); ++i)
    sum += cross(border[i - 1] - border[0], border[i] - border[0]);
  return sum;
}

bool is_planar_convex(const Border& border) {
  const std::size_t count = border.size();
  if (count == 3) return true;
  const Vertex normal = cross(border[1] - border[0], border[2] - border[1]);
  for (const Vertex& vertex : border)
    if (dot(normal, vertex - border[0]) != 0) return false;
  const int axis = dominant_axis(normal), u = (axis + 1) % 3, v = (axis + 2) % 3;
  int half_turns = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vertex& here = border[(i + 1) % count];
    const Vertex before = here - border[i], after = border[(i + 2) % count] - here;
    const std::int64_t turn = before[u] * after[v] - before[v] * after[u];
    if ((turn > 0) != (normal[axis] > 0)) return false;
    half_turns += is_second_half(before[u], before[v]) != is_second_half(after[u], after[v]);
  }
  return half_turns == 2;
}

}  // namespace rc2::facet
