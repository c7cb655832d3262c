#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "fmt/format.h"
#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/facet/bounds.h"
#include "sw/facet/cube.h"
#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"
#include "sw/facet/traced.h"

namespace rc2::facet {
namespace {

class Builder {
 public:
  Builder(const scene::Scene& scene, int n, int fraction_bits, Rule rule, Traced* traced)
      : scene_(scene), grid_{n, std::int64_t{1} << fraction_bits, rule}, traced_(traced) {}

  FacetSet build() {
    const std::size_t polygons = scene_.polygon_count(), corners = scene_.vertices.size();
    const std::size_t sides = grid_.rule == Rule::supercover ? 3 * corners : corners;
    set_.facets.reserve(polygons);
    set_.packets.heads.reserve(polygons);
    set_.packets.sides.reserve(sides);
    for (std::size_t i = 0; i < polygons; ++i) add_polygon(i);
    set_.counts.read = static_cast<std::int64_t>(polygons);
    set_.counts.loaded = static_cast<std::int64_t>(set_.facets.size());
    return std::move(set_);
  }

 private:
  void add_polygon(std::size_t polygon) {
    if (!quantise(polygon)) {
      ++set_.counts.outside;
      return;
    }
    if (traced_ != nullptr) trace_polygon();
    clean(border_);
    if (border_.size() < 3) {
      ++set_.counts.degenerate;
    } else if (is_planar_convex(border_)) {
      add_facet(border_, polygon);
    } else {
      ++set_.counts.triangulated;
      triangles_.clear();
      triangulate(border_, triangles_);
      for (const Triangle& triangle : triangles_) {
        border_.assign(triangle.begin(), triangle.end());
        clean(border_);
        if (border_.size() < 3)
          ++set_.counts.degenerate;
        else
          add_facet(border_, polygon);
      }
    }
  }

  void trace_polygon() {
    traced_->corners.insert(traced_->corners.end(), border_.begin(), border_.end());
    traced_->first.push_back(traced_->corners.size());
  }

  void trace_piece(const Border& border, const Vertex& normal, std::optional<std::uint32_t> facet) {
    const auto polygon = static_cast<std::uint32_t>(traced_->polygon_count() - 1);
    traced_->pieces.push_back({border, normal, polygon, facet});
  }

  // Sets border_ to the polygon in vertex units. False if it lies outside the cube.
  bool quantise(std::size_t polygon) {
    const glm::dvec3* first = scene_.vertices.data() + scene_.first[polygon];
    const glm::dvec3* last = scene_.vertices.data() + scene_.first[polygon + 1];
    const auto one = static_cast<double>(grid_.one);
    border_.clear();
    const glm::dvec3* stray = nullptr;
    for (const glm::dvec3* p = first; p != last; ++p) {
      if (!std::isfinite(p->x) || !std::isfinite(p->y) || !std::isfinite(p->z))
        throw Error(
            fmt::format("{}: polygon {} has a vertex that is not a finite number; repair "
                        "the mesh",
                        scene_.name, polygon));
      const glm::dvec3 rounded = glm::floor(*p * one + 0.5);
      for (int axis = 0; axis < 3; ++axis)
        if (rounded[axis] < -0.5 * one || rounded[axis] > (grid_.n - 0.5) * one) stray = p;
      if (stray == nullptr) border_.emplace_back(rounded);
    }
    if (stray == nullptr) return true;
    if (reaches_cube({first, last}, grid_.n))
      throw Error(
          fmt::format("{}: polygon {} crosses the border of the cube, its vertex ({}, {}, "
                      "{}) is not within -0.5 .. {}; use --fit cube or clip the mesh",
                      scene_.name, polygon, stray->x, stray->y, stray->z, grid_.n - 0.5));
    return false;
  }

  void add_facet(const Border& border, std::size_t polygon) {
    const Vertex normal = plane_normal(border);
    if (set_.facets.size() == kMaxFacets)
      throw Error(
          fmt::format("{}: there are more than {} facets, the most the machine can number; "
                      "simplify the mesh",
                      scene_.name, kMaxFacets));
    const auto number = static_cast<std::uint32_t>(set_.facets.size());
    const bool has_voxels = append_packet(border, normal, number, grid_, set_.packets);
    if (has_voxels)
      set_.facets.push_back({glm::normalize(glm::dvec3(normal)),
                             scene_.material[polygon],
                             {normal, dot(normal, border.front())}});
    else
      ++set_.counts.outside;
    if (traced_ != nullptr)
      trace_piece(border, normal, has_voxels ? std::optional(number) : std::nullopt);
  }

  const scene::Scene& scene_;
  Grid grid_;
  Traced* traced_;
  FacetSet set_;
  Border border_;
  std::vector<Triangle> triangles_;
};

FacetSet build_checked(const scene::Scene& scene, int n, int fraction_bits, Rule rule,
                       Traced* traced) {
  if (n < 2 || n > kMaxSide)
    throw Error(
        fmt::format("--n {}: a cube of that side cannot be built; choose 2 to {}", n, kMaxSide));
  if (fraction_bits < 0 || fraction_bits > kMaxFractionBits)
    throw Error(
        fmt::format("--fraction-bits {}: vertices cannot be rounded like that; choose 0 "
                    "to {}",
                    fraction_bits, kMaxFractionBits));
  return Builder(scene, n, fraction_bits, rule, traced).build();
}

}  // namespace

FacetSet build_facets(const scene::Scene& scene, int n, int fraction_bits, Rule rule) {
  return build_checked(scene, n, fraction_bits, rule, nullptr);
}

FacetSet build_facets(const scene::Scene& scene, int n, int fraction_bits, Rule rule,
                      Traced& traced) {
  return build_checked(scene, n, fraction_bits, rule, &traced);
}

}  // namespace rc2::facet
