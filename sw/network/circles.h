#pragma once

#include "sw/network/network.h"

namespace rc2::network {

/// Thesis 2.4.1: each circle is a tree of its own over its arc, rooted at (R, 0). No two
/// circles share a pixel, so every planned link is right.
Network build_circles(int max_radius, Scheme scheme);

}  // namespace rc2::network
