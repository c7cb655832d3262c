#include "tb/stress/bodies.h"

#include <algorithm>

namespace rc2::stress {

using facet::Vertex;

bool is_in_a_body(const std::vector<Body>& bodies, const Cube& cube, const glm::ivec3& voxel) {
  const Vertex centre = Vertex(voxel) * cube.one();
  return std::any_of(bodies.begin(), bodies.end(), [&](const Body& body) {
    return std::all_of(body.begin(), body.end(), [&](const Border& border) {
      const Vertex outwards = facet::doubled_area(border);
      const std::int64_t height = facet::dot(outwards, centre - border[0]);
      return height < 0 || (height == 0 && !facet::keeps_ties(outwards));
    });
  });
}

bool share_a_facet(const std::vector<Body>& bodies) {
  for (const Body& a : bodies) {
    const auto is_of_a = [&](const Border& border) {
      return std::find(a.begin(), a.end(), border) != a.end();
    };
    for (const Body& b : bodies)
      if (std::any_of(b.begin(), b.end(), is_of_a) && !std::all_of(b.begin(), b.end(), is_of_a))
        return true;
  }
  return false;
}

}  // namespace rc2::stress
