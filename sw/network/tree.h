#pragma once

#include <vector>

namespace rc2::network {

/// The tree that every scheme plans its links with, over the places 0 .. count-1 along a drawing:
/// the place it hangs from, -1 for the root 0. A place feeds the first place of each of at most
/// `fan_out` nearly equal parts of what lies behind it, so that subtrees never interleave.
/// Fan-out 1 is a chain; count or more hangs every place from the root.
std::vector<int> tree_parents(int count, int fan_out);

}  // namespace rc2::network
