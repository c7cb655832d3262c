#include "sw/facet/cube.h"

namespace rc2::facet {
namespace {

// Sutherland-Hodgman: keeps the part of the polygon where side * (p[axis] - limit) <= 0.
std::vector<glm::dvec3> clip(const std::vector<glm::dvec3>& corners, int axis, double side,
                             double limit) {
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const double a = side * (from[axis] - limit), b = side * (to[axis] - limit);
    if (a <= 0.0) kept.push_back(from);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))
      kept.push_back(from + (to - from) * (a / (a - b)));
  }
  return kept;
}

}  // namespace

bool reaches_cube(std::vector<glm::dvec3> corners, int n) {
  for (int axis = 0; axis < 3; ++axis) {
    corners = clip(corners, axis, -1.0, -0.5);
    corners = clip(corners, axis, 1.0, n - 0.5);
  }
  return !corners.empty();
}

}  // namespace rc2::facet
