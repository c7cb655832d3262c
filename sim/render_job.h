// What render and render-error have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/camera.h"
#include "sim/job.h"
#include "sim/lights.h"
#include "sw/picture/render.h"

namespace rc2 {

/// Vertices are rounded to 1/64 voxel, the unit of a ray's place.
constexpr int kRenderFraction = 6;

/// A hundredth: what is worth less is not followed.
constexpr int kDefaultLeastWeight = rays::kWeightOne / 100;

/// --view: front, camera.
void declare_view(CLI::App& command, std::string& view);

/// The picture's rays. Throws Error if a camera is asked for and there is none.
std::vector<Sight> sights_of(const scene::Scene& scene, const std::string& view, int n);

/// The lamps and what they left behind, together.
std::vector<picture::Lamp> lit_lamps(const std::vector<Lamp>& lamps,
                                     const std::vector<LightMemory>& arrived);

/// What the polygons of the scene belong to, as far as they became facets.
std::vector<rays::Body> bodies_of(const Job& job);

}  // namespace rc2
