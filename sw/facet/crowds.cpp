#include "sw/facet/crowds.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace rc2::facet {
namespace {

constexpr double kCube = 4;      // side, voxels
constexpr double kLayers = 2.5;  // of a cube's section each
constexpr double kSamplesPerSection = 8;
constexpr double kMostSamples = 1024;  // of a large facet: time

// Roberts's sequence R2: evenly spread whatever the number of points.
constexpr double kStepU = 0.7548776662466927, kStepV = 0.5698402909980532;

struct Sample {
  std::uint64_t cube;
  double area;  // that it stands for, in squares of the cube's side
};

template <class Visit>
void for_each_sample(const Border& border, std::int64_t one, Visit visit) {
  const double unit = 1 / (kCube * static_cast<double>(one));
  for (std::size_t k = 1; k + 1 < border.size(); ++k) {
    const glm::dvec3 a = glm::dvec3(border[0]) * unit, u = glm::dvec3(border[k]) * unit - a,
                     v = glm::dvec3(border[k + 1]) * unit - a;
    const double area = 0.5 * glm::length(glm::cross(u, v));
    const double count = std::clamp(std::ceil(area * kSamplesPerSection), 1.0, kMostSamples);
    for (double i = 0; i < count; ++i) {
      double s = std::fmod(0.5 + i * kStepU, 1.0), t = std::fmod(0.5 + i * kStepV, 1.0);
      if (s + t > 1) {
        s = 1 - s;
        t = 1 - t;
      }
      const glm::u64vec3 cube(glm::floor(a + s * u + t * v) + 1.0);
      visit(Sample{(cube.x << 20 | cube.y) << 20 | cube.z, area / count});
    }
  }
}

}  // namespace

std::vector<bool> find_crowded(const Traced& traced, const std::vector<const Pieces*>& shells,
                               std::int64_t one) {
  std::unordered_map<std::uint64_t, double> surface;  // of each cube
  for (const Traced::Piece& piece : traced.pieces) {
    if (!piece.facet) continue;
    // One of few samples stands for more than a cube can hold of a single facet.
    for_each_sample(piece.border, one,
                    [&](const Sample& s) { surface[s.cube] += std::min(s.area, 1.0); });
  }
  std::vector<bool> is_crowded(traced.pieces.size());
  for (const Pieces* shell : shells) {
    double shell_area = 0, crowded_area = 0;
    for (const std::uint32_t i : *shell) {
      if (!traced.pieces[i].facet) continue;
      double area = 0, around = 0;
      for_each_sample(traced.pieces[i].border, one, [&](const Sample& s) {
        area += s.area;
        around += s.area * surface[s.cube];
      });
      is_crowded[i] = around > kLayers * area;
      shell_area += area;
      if (is_crowded[i]) crowded_area += area;
    }
    if (2 * crowded_area <= shell_area) continue;
    for (const std::uint32_t i : *shell) is_crowded[i] = true;
  }
  return is_crowded;
}

}  // namespace rc2::facet
