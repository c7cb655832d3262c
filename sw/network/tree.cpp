#include "sw/network/tree.h"

#include <algorithm>
#include <cstdint>

namespace rc2::network {

std::vector<int> tree_parents(int count, int fan_out) {
  std::vector<int> parents(count, -1);
  struct Stretch {
    int root, end;
  };
  std::vector<Stretch> open{{0, count}};
  while (!open.empty()) {
    const Stretch stretch = open.back();
    open.pop_back();
    const int first = stretch.root + 1;
    const std::int64_t places = stretch.end - first;
    const std::int64_t parts = std::min<std::int64_t>(places, fan_out);
    for (std::int64_t part = 0; part < parts; ++part) {
      const int root = first + static_cast<int>(places * part / parts);
      parents[root] = stretch.root;
      open.push_back({root, first + static_cast<int>(places * (part + 1) / parts)});
    }
  }
  return parents;
}

}  // namespace rc2::network
