#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "fmt/format.h"
#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/facet/bounds.h"
#include "sw/facet/cube.h"
#include "sw/facet/facet.h"
#include "sw/facet/polygon.h"
#include "sw/facet/reserve_large.h"
#include "sw/facet/traced.h"

namespace rc2::facet {
namespace {

class Builder {
 public:
  Builder(const scene::Scene& scene, int n, int fraction_bits, Rule rule, Traced* traced)
      : scene_(scene), grid_{n, std::int64_t{1} << fraction_bits, rule}, traced_(traced) {}

  FacetSet build() {
    const std::size_t polygons = scene_.polygon_count();
    // If every polygon had to be cut into triangles.
    const std::size_t most =
        polygons + std::max(scene_.vertices.size(), 3 * polygons) - 3 * polygons;
    reserve_large(set_.facets, most);
    reserve_large(set_.packets.heads, most);
    reserve_large(set_.packets.sides, (grid_.rule == Rule::supercover ? 9 : 3) * most);
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
    border_.clear();
    for (std::uint32_t i = scene_.first[polygon]; i < scene_.first[polygon + 1]; ++i) {
      const glm::dvec3 exact = scene_.vertices[i] * static_cast<double>(grid_.one);
      if (!is_in_cube(exact)) {
        refuse_unless_outside(polygon);
        return false;
      }
      border_.emplace_back(nearest(exact.x), nearest(exact.y), nearest(exact.z));
    }
    return true;
  }

  // Whether the vertex nearest to this is in the cube; not, if it is not finite.
  bool is_in_cube(const glm::dvec3& exact) const {
    const std::int64_t least = -(grid_.one / 2), most = grid_.n * grid_.one - (grid_.one + 1) / 2;
    const double lowest = static_cast<double>(least) - 0.5, end = static_cast<double>(most) + 0.5;
    return exact.x >= lowest && exact.y >= lowest && exact.z >= lowest && exact.x < end &&
           exact.y < end && exact.z < end;
  }

  // Ties up. The difference is exact; the sum of a value and 1/2 would not be, and rounds the
  // number below 1/2 to 1. std::floor is a call unless the compiler may use instructions that not
  // every x86 has.
  static std::int64_t nearest(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    const double rest = value - static_cast<double>(whole);
    return whole + (rest >= 0.5 ? 1 : 0) - (rest < -0.5 ? 1 : 0);
  }

  // Of a polygon that has a vertex outside the cube.
  void refuse_unless_outside(std::size_t polygon) const {
    const auto corner = [&](std::uint32_t i) { return scene_.vertices.begin() + i; };
    const std::vector<glm::dvec3> corners(corner(scene_.first[polygon]),
                                          corner(scene_.first[polygon + 1]));
    for (const glm::dvec3& p : corners)
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw Error(
            fmt::format("{}: polygon {} has a vertex that is not a finite number; repair "
                        "the mesh",
                        scene_.name, polygon));
    if (!reaches_cube(corners, grid_.n)) return;
    const auto stray = std::find_if(corners.begin(), corners.end(), [&](const glm::dvec3& p) {
      return !is_in_cube(p * static_cast<double>(grid_.one));
    });
    throw Error(
        fmt::format("{}: polygon {} crosses the border of the cube, its vertex ({}, {}, "
                    "{}) is not within -0.5 .. {}; use --fit cube or clip the mesh",
                    scene_.name, polygon, stray->x, stray->y, stray->z, grid_.n - 0.5));
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
    if (has_voxels) {
      FacetInfo& info = set_.facets.emplace_back();
      info.normal = glm::normalize(glm::dvec3(normal));
      info.material = scene_.material[polygon];
      info.polygon = static_cast<std::uint32_t>(polygon);
      info.plane = {normal, dot(normal, border.front())};
    } else {
      ++set_.counts.outside;
    }
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
