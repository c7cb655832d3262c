// What render and render-error have in common.
#pragma once

#include <string>
#include <vector>

#include "sim/camera.h"
#include "sim/command_line.h"
#include "sim/job.h"

namespace rc2 {

/// Vertices are rounded to 1/64 voxel, the unit of a ray's place.
constexpr int kRenderFraction = 6;

/// Share of its pixel that a ray must be worth to be followed.
constexpr double kDefaultLeastWeight = 0.01;

/// In the unit of a ray's weight.
int weight_of(double share);

/// --view: front, camera.
void declare_view(Command& command, std::string& view);

/// The picture's rays. Throws Error if a camera is asked for and there is none.
std::vector<Sight> sights_of(const scene::Scene& scene, const std::string& view, int n);

/// What RayJob::starts wants: from the front the machine begins the rays itself.
const std::vector<RayStart>* starts_for(const std::string& view,
                                        const std::vector<RayStart>& starts);

/// Every facet reflects all.
void make_mirrors(std::vector<rays::Facet>& optics);

/// What the polygons of the scene belong to, as far as they became facets.
std::vector<rays::Body> bodies_of(const Job& job);

}  // namespace rc2
