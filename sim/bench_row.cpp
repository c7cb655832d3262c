#include "sim/bench_row.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/build_info.h"
#include "sw/picture/render.h"
#include "sw/surface/mesh.h"
#include "sw/surface/tunnels.h"
#include "sw/surface/winding.h"

namespace rc2 {
namespace {

template <typename Value>
std::string word(const std::optional<Value>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string words(const std::optional<std::array<Errors, kPopulations.size()>>& errors) {
  std::string text;
  for (std::size_t i = 0; i < kPopulations.size(); ++i) {
    if (!errors) {
      text += ",,,,,";
      continue;
    }
    const Errors& of = (*errors)[i];
    text += fmt::format(",{},{},{},{},{}", of.voxels, of.dark, of.lit, of.dark_tolerant,
                        of.lit_tolerant);
  }
  return text;
}

std::string header() {
  std::string text =
      "commit,scene,method,n,f,W,rule,light_rule,mode,skip,L,fa,light,x,y,z,facets,voxels,"
      "uncovered_percent,distance,tunnels_6,tunnels_26,prepare_seconds,load_seconds,light_seconds,"
      "load_cycles,light_cycles,visits,merged,deepest,peak_kilobytes";
  for (const Population population : kPopulations)
    for (const char* count :
         {"", "_false_dark", "_false_lit", "_false_dark_tolerant", "_false_lit_tolerant"})
      text += fmt::format(",{}{}", to_string(population), count);
  return text + ",wrong_pixels_percent,rmse,flip\n";
}

constexpr double kNear = 1.0 / 32;  // rounding moves a surface a little

std::int64_t peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

VoxelError voxel_error(const LightStage& stage, const std::vector<glm::ivec3>& voxels) {
  VoxelError error;
  error.voxels = static_cast<std::int64_t>(voxels.size());
  surface::VoxelSet occupied(stage.n);
  for (const glm::ivec3& voxel : voxels) {
    occupied[voxel] = 1;
    error.distance += glm::distance(stage.surface.nearest(voxel).at, glm::dvec3(voxel));
  }
  if (!voxels.empty()) error.distance /= static_cast<double>(voxels.size());
  const truth::Samples::Range points = stage.samples.all();
  const auto uncovered = std::count_if(points.begin(), points.end(), [&](const truth::Sample& of) {
    return !surface::covers(occupied, of.at, kNear);
  });
  if (stage.samples.count() > 0)
    error.uncovered_percent =
        100 * static_cast<double>(uncovered) / static_cast<double>(stage.samples.count());
  const surface::Mesh mesh = surface::quantise(stage.scene, stage.fraction_bits);
  if (mesh.closed) {
    const surface::Tunnels tunnels =
        surface::count_tunnels(occupied, surface::winding_numbers(mesh, stage.n));
    error.tunnels_6 = tunnels.by_6;
    error.tunnels_26 = tunnels.by_26;
  }
  return error;
}

// The picture is drawn by what draws the machine's (picture::render), from a memory in which each
// column holds the triangle that Embree sees there.
PictureError::PictureError(const LightStage& stage) : stage_(stage) {
  for (const std::size_t number : stage.shown.numbers()) drawn_.push_back(stage.voxels[number]);
  const truth::Triangles& triangles = stage.surface.triangles();
  const auto any = [](std::uint32_t, bool) { return true; };
  const double from = stage.n;
  for (int y = 0; y < stage.n; ++y) {
    for (int x = 0; x < stage.n; ++x) {
      const auto met = stage.surface.first_met({x, y, from}, {0, 0, -1}, any);
      if (!met) continue;
      const glm::dvec3 at(x, y, from - met->distance);
      const auto z = static_cast<int>(std::floor(at.z + 0.5));
      const glm::dvec3 normal = glm::normalize(triangles.doubled_area(met->triangle));
      seen_.push_back({{x, y, glm::clamp(z, 0, stage.n - 1)},
                       Claim{static_cast<std::uint32_t>(triangles_.size())}});
      triangles_.push_back({normal, stage.scene.material[triangles.polygon[met->triangle]]});
      at_.push_back(at + truth::kLift * (met->is_back ? -normal : normal));
    }
  }
}

picture::Difference PictureError::compare(const glm::ivec3& light,
                                          const LightMemory& arrived) const {
  LightMemory drawn, truly;
  for (const std::size_t number : stage_.shown.numbers()) drawn.push_back(arrived[number]);
  truly.reserve(at_.size());
  for (const glm::dvec3& at : at_) truly.push_back(stage_.surface.sees(at, light) ? 1 : 0);
  const auto draw = [&](const VoxelMemory& voxels, const LightMemory& lit,
                        const std::vector<facet::FacetInfo>& facets) {
    return picture::render(stage_.n, voxels, {{light, glm::vec3(1), lit}}, facets,
                           stage_.scene.materials);
  };
  return picture::difference(draw(drawn_, drawn, stage_.facets.facets),
                             draw(seen_, truly, triangles_));
}

std::string to_csv(const std::vector<BenchRow>& rows) {
  std::string csv = header();
  const std::string commit = source_commit();
  for (const BenchRow& row : rows) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", commit, row.scene,
                       row.method, row.n, row.fraction_bits, word(row.coefficient_bits), row.rule,
                       row.light_rule, row.mode, row.skips ? (*row.skips ? "on" : "off") : "",
                       word(row.distance), word(row.fa), word(row.light), row.at.x, row.at.y,
                       row.at.z, row.facets);
    csv += fmt::format(",{},{:.4f},{:.4f},{},{},{:.6f},{:.6f},{}", row.voxels.voxels,
                       row.voxels.uncovered_percent, row.voxels.distance,
                       word(row.voxels.tunnels_6), word(row.voxels.tunnels_26), row.prepare_seconds,
                       row.load_seconds, word(row.light_seconds));
    csv += fmt::format(",{},{},{},{},{},{}", word(row.load_cycles), word(row.light_cycles),
                       word(row.visits), word(row.merged), word(row.deepest), peak_kilobytes());
    csv += words(row.errors);
    csv += row.picture ? fmt::format(",{:.4f},{:.5f},{:.5f}\n", 100 * row.picture->wrong,
                                     row.picture->rmse, row.picture->flip)
                       : ",,,\n";
  }
  return csv;
}

}  // namespace rc2
