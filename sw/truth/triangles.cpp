#include "sw/truth/triangles.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sw/facet/polygon.h"

namespace rc2::truth {
namespace {

// Cuts a polygon by its shape on a grid of 2^18 steps, which is fine enough to tell its corners
// apart and coarse enough for exact arithmetic.
class Cutter {
 public:
  explicit Cutter(Triangles& result) : result_(result) {}

  void cut(std::uint32_t first, std::uint32_t last) {
    if (last - first == 3) {
      result_.corners.emplace_back(first, first + 1, first + 2);
      return;
    }
    place_on_grid(first, last);
    pieces_.clear();
    facet::triangulate(border_, pieces_);
    for (const facet::Triangle& piece : pieces_) {
      result_.corners.emplace_back(first + corner(piece[0]), first + corner(piece[1]),
                                   first + corner(piece[2]));
    }
  }

 private:
  void place_on_grid(std::uint32_t first, std::uint32_t last) {
    glm::dvec3 low = result_.vertices[first], high = low;
    for (std::uint32_t i = first; i < last; ++i) {
      low = glm::min(low, result_.vertices[i]);
      high = glm::max(high, result_.vertices[i]);
    }
    const glm::dvec3 extent = high - low;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const double scale = longest > 0 ? 0x1p18 / longest : 0;
    border_.clear();
    for (std::uint32_t i = first; i < last; ++i)
      border_.emplace_back(glm::floor((result_.vertices[i] - low) * scale + 0.5));
  }

  std::uint32_t corner(const facet::Vertex& place) const {
    return static_cast<std::uint32_t>(std::find(border_.begin(), border_.end(), place) -
                                      border_.begin());
  }

  Triangles& result_;
  facet::Border border_;
  std::vector<facet::Triangle> pieces_;
};

}  // namespace

glm::dvec3 Triangles::doubled_area(std::size_t triangle) const {
  const glm::uvec3& at = corners[triangle];
  return glm::cross(vertices[at.y] - vertices[at.x], vertices[at.z] - vertices[at.x]);
}

Triangles triangles_of(const scene::Scene& scene) {
  Triangles result{scene.vertices, {}, {}};
  Cutter cutter(result);
  for (std::size_t i = 0; i < scene.polygon_count(); ++i) {
    cutter.cut(scene.first[i], scene.first[i + 1]);
    result.polygon.resize(result.corners.size(), static_cast<std::uint32_t>(i));
  }
  return result;
}

}  // namespace rc2::truth
