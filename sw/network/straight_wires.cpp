#include <algorithm>

#include "sw/network/measure.h"

namespace rc2::network {
namespace {

struct Wire {
  glm::ivec2 a, b;
};

/// Twice the signed area of a triangle; at most 2^21 for pixels of the largest network.
int area(glm::ivec2 p, glm::ivec2 q, glm::ivec2 r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

int sign(int value) { return (value > 0) - (value < 0); }

int dot(glm::ivec2 p, glm::ivec2 q) { return p.x * q.x + p.y * q.y; }

/// Is p, which lies on the wire's line, strictly between its ends?
bool inside(const Wire& wire, glm::ivec2 p) { return dot(wire.a - p, wire.b - p) < 0; }

bool collinear_overlap(const Wire& u, const Wire& v) {
  const bool same = (u.a == v.a && u.b == v.b) || (u.a == v.b && u.b == v.a);
  return same || inside(u, v.a) || inside(u, v.b) || inside(v, u.a) || inside(v, u.b);
}

void judge(const Wire& u, const Wire& v, Disturbances& found) {
  const int va = sign(area(u.a, u.b, v.a));
  const int vb = sign(area(u.a, u.b, v.b));
  if (va * vb > 0) return;
  const int ua = sign(area(v.a, v.b, u.a));
  const int ub = sign(area(v.a, v.b, u.b));
  if (ua * ub > 0) return;
  if (va == 0 && vb == 0) {
    found.overlaps += static_cast<int>(collinear_overlap(u, v));
  } else if (va * vb < 0 && ua * ub < 0) {
    ++found.crossings;
  } else {
    const bool through = (va == 0 && inside(u, v.a)) || (vb == 0 && inside(u, v.b)) ||
                         (ua == 0 && inside(v, u.a)) || (ub == 0 && inside(v, u.b));
    found.through += static_cast<int>(through);
  }
}

}  // namespace

Disturbances straight_wires(const Network& network) {
  std::vector<Wire> wires;
  for (const Link& link : network.links) {
    Wire wire{network.cells[link.from], network.cells[link.to]};
    if (wire.a.x > wire.b.x) std::swap(wire.a, wire.b);
    wires.push_back(wire);
  }
  std::sort(wires.begin(), wires.end(), [](const Wire& u, const Wire& v) { return u.a.x < v.a.x; });
  Disturbances found;
  for (std::size_t first = 0; first < wires.size(); ++first) {
    const Wire& u = wires[first];
    for (std::size_t second = first + 1; second < wires.size(); ++second) {
      const Wire& v = wires[second];
      if (v.a.x > u.b.x) break;
      if (std::max(u.a.y, u.b.y) < std::min(v.a.y, v.b.y)) continue;
      if (std::max(v.a.y, v.b.y) < std::min(u.a.y, u.b.y)) continue;
      judge(u, v, found);
    }
  }
  return found;
}

}  // namespace rc2::network
