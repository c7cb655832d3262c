#pragma once

#include "sw/network/network.h"

namespace rc2::network {

/// Thesis 2.4.2: a tree along every segment, rooted in the last column. Segments share pixels, so a
/// planned link is wrong when a segment passes its tail and misses its head; it is replaced by the
/// link from the nearest right tail on the same segment, on a tie the one nearer the end point.
/// With scheme.keep_depth only tails that are on when the plan needs them come into question: the
/// depth is then the tree's. Without it moved links line up into long chains.
Network build_segments(int n, Scheme scheme);

}  // namespace rc2::network
