// From floating point to vertices: the one door where numbers are rounded.
#pragma once

#include "tb/stress/trial.h"

namespace rc2::stress {

/// Triangles whose coordinates are halves of a vertex unit, the floating-point numbers next to
/// them, tiny ones and the ends of the range: the vertices that the host makes of them with exact
/// rational arithmetic, the nearest multiple of 2^-f, ties up. Returns how many coordinates
/// differ.
std::int64_t check_rounding(std::uint64_t seed, std::int64_t trials, Findings& findings);

}  // namespace rc2::stress
