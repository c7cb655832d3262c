#include "sw/network/circles.h"

#include "sw/network/raster.h"
#include "sw/network/tree.h"

namespace rc2::network {

Network build_circles(int max_radius, Scheme scheme) {
  Network network;
  network.size = max_radius;
  for (int radius = 0; radius <= max_radius; ++radius) {
    const std::vector<glm::ivec2> arc = circle_arc(radius);
    const std::vector<int> parents = tree_parents(static_cast<int>(arc.size()), scheme.fan_out);
    const int root = static_cast<int>(network.cells.size());
    network.starts.push_back(root);
    network.cells.insert(network.cells.end(), arc.begin(), arc.end());
    for (int place = 1; place < static_cast<int>(arc.size()); ++place) {
      network.links.push_back({root + parents[place], root + place});
    }
  }
  return network;
}

}  // namespace rc2::network
