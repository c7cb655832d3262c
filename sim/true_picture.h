// The picture that rays are compared with.
#pragma once

#include <vector>

#include "sim/camera.h"
#include "sim/lights.h"
#include "sw/picture/image.h"
#include "sw/truth/whitted.h"

namespace rc2 {

/// What Whitted's ray tracer sees along `sights`, row by row from y = 0, with so many bounces.
picture::Image true_picture(const truth::Whitted& truth, const std::vector<Sight>& sights,
                            const std::vector<Lamp>& lamps, int depth, bool has_shadows);

}  // namespace rc2
