// A file's camera: one ray for each pixel.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sw/machine/ray_job.h"
#include "sw/scene/scene.h"

namespace rc2 {

/// A ray through the continuous scene; direction of unit length.
struct Sight {
  glm::dvec3 from, direction;
};

/// Through the middle of each pixel of a camera in voxel coordinates, row by row from y = 0 (the
/// lowest). Throws Error if the camera looks along its own up.
std::vector<Sight> camera_sights(const scene::Camera& camera, int n);

/// Those of a viewer who looks along -z from the front of the cube.
std::vector<Sight> front_sights(int n);

/// The same for the machine: a ray that starts outside the cube starts where it enters it, one that
/// misses it has no direction. Rounded.
std::vector<RayStart> ray_starts(const std::vector<Sight>& sights, int n);

}  // namespace rc2
