#include "sw/surface/mesh.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <map>

namespace rc2::surface {
namespace {

using facet::Border;
using facet::Vertex;

struct Before {
  bool operator()(const Vertex& a, const Vertex& b) const {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  }
};

// How often each side is used, one direction counted against the other.
class Sides {
 public:
  void add(const Border& border) {
    for (std::size_t i = 0; i < border.size(); ++i) {
      const int from = number(border[i]), to = number(border[(i + 1) % border.size()]);
      if (from != to) uses_[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }

  bool cancel() const {
    return std::all_of(uses_.begin(), uses_.end(),
                       [](const auto& side) { return side.second == 0; });
  }

 private:
  int number(const Vertex& vertex) {
    return numbers_.emplace(vertex, static_cast<int>(numbers_.size())).first->second;
  }

  std::map<Vertex, int, Before> numbers_;
  std::map<std::pair<int, int>, int> uses_;
};

void add_convex_parts(Border border, std::vector<Border>& facets) {
  facet::clean(border);
  if (border.size() < 3) return;
  if (facet::is_planar_convex(border)) {
    facets.push_back(std::move(border));
    return;
  }
  std::vector<facet::Triangle> triangles;
  facet::triangulate(border, triangles);
  for (const facet::Triangle& triangle : triangles) {
    border.assign(triangle.begin(), triangle.end());
    facet::clean(border);
    if (border.size() == 3) facets.push_back(border);
  }
}

}  // namespace

Mesh quantise(const scene::Scene& scene, int fraction_bits) {
  Mesh mesh{fraction_bits, {}, false};
  const auto one = static_cast<double>(1 << fraction_bits);
  Sides sides;
  Border border;
  for (std::size_t i = 0; i < scene.polygon_count(); ++i) {
    border.clear();
    for (std::uint32_t k = scene.first[i]; k < scene.first[i + 1]; ++k)
      border.emplace_back(glm::floor(scene.vertices[k] * one + 0.5));
    sides.add(border);
    add_convex_parts(border, mesh.facets);
  }
  mesh.closed = sides.cancel();
  return mesh;
}

}  // namespace rc2::surface
