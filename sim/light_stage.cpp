#include "sim/light_stage.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <glm/common.hpp>
#include <limits>

#include "sim/light_scenes.h"
#include "sim/timed_load.h"
#include "sw/facet/layers.h"
#include "sw/facet/turns_away.h"
#include "sw/golden/golden_machine.h"
#include "sw/surface/rounding.h"

namespace rc2 {
namespace {

constexpr double kDensity = 32;  // samples per unit of area

// Shares of n.
const std::array<glm::dvec3, kStageLights> kLights{{{0.90, 0.95, 0.85},
                                                    {0.06, 0.55, 0.62},
                                                    {0.52, 0.48, 0.96},
                                                    {0.10, 0.07, 0.12},
                                                    {0.94, 0.32, 0.10},
                                                    {0.45, 0.05, 0.56}}};

scene::Scene lit_scene(const std::string& name, int n) {
  scene::Scene scene = make_light_scene(name, n);
  if (scene.polygon_count() == 0)
    throw Error(fmt::format("{}: there is nothing to light; choose a scene with facets", name));
  return scene;
}

template <typename Step>
auto timed(double& seconds, Step step) {
  Best watch;
  auto result = watch.time(step);
  seconds = watch.seconds();
  return result;
}

}  // namespace

LightStage::LightStage(const std::string& name, int side, int f, facet::Rule rule,
                       std::optional<int> coefficient_bits, const Progress& progress)
    : title(std::filesystem::path(name).filename()),
      n(side),
      fraction_bits(f),
      scene(lit_scene(name, n)),
      facets(timed(packet_seconds,
                   [&] {
                     facet::FacetSet set = rule == facet::Rule::armoured
                                               ? facet::build_layers(scene, n, f)
                                               : facet::build_facets(scene, n, f, rule);
                     if (coefficient_bits)
                       set.packets = surface::round_slabs(set.packets, {}, *coefficient_bits,
                                                          surface::Rounding::widened);
                     return set;
                   })),
      voxels(timed(load_seconds,
                   [&] {
                     MachineConfig config;
                     config.n = n;
                     config.fraction_bits = f;
                     golden::GoldenMachine machine(config);
                     machine.load(facets.packets, progress);
                     layers = machine.read_layers();
                     if (rule != facet::Rule::armoured)
                       for (LayerRecord& layer : layers) layer.shown = true;
                     return machine.read_voxels();
                   })),
      shown(layers, voxels, n),
      surface(scene),
      samples(surface, n, kDensity) {}

glm::ivec3 LightStage::light(int number) const {
  std::vector<bool> is_free(static_cast<std::size_t>(n) * n * n, true);
  const auto place = [this](const glm::ivec3& at) {
    return (static_cast<std::size_t>(at.z) * n + at.y) * n + at.x;
  };
  for (const LayerRecord& layer : layers)
    if (layer.armour || layer.inside) is_free[place(layer.at)] = false;
  const glm::dvec3 share = kLights.at(static_cast<std::size_t>(number));
  const glm::ivec3 wanted(glm::floor(share * static_cast<double>(n)));
  glm::ivec3 best(-1);
  int best_square = std::numeric_limits<int>::max();
  for (glm::ivec3 at{0}; at.z < n; ++at.z)
    for (at.y = 0; at.y < n; ++at.y)
      for (at.x = 0; at.x < n; ++at.x) {
        const glm::ivec3 way = at - wanted;
        const int square = way.x * way.x + way.y * way.y + way.z * way.z;
        if (square >= best_square || !is_free[place(at)]) continue;
        best = at;
        best_square = square;
      }
  if (best_square == std::numeric_limits<int>::max())
    throw Error("every voxel is occupied, so no light can be placed; use a larger --n");
  return best;
}

std::vector<truth::Verdict> LightStage::judge(const glm::ivec3& light) const {
  return truth::judge(surface, samples, shown.places(), light);
}

std::vector<bool> LightStage::away(const glm::ivec3& light) const {
  std::vector<bool> away;
  away.reserve(facets.facets.size());
  for (const facet::FacetInfo& facet : facets.facets)
    away.push_back(facet::turns_away(facet, light, fraction_bits));
  return away;
}

}  // namespace rc2
