#include "sw/rays/face.h"

#include <algorithm>

namespace rc2::rays {
namespace {

constexpr std::int64_t kVoxel = std::int64_t{kPlaceOne} << kNormalFraction;

// How far over a plane a ray must start to come through it.
//  - In a room a hit beside an edge may lie a little behind the wall beyond the edge.
//  - What is seen from both sides, or passed straight, would be met again at once by a ray from it.
std::int64_t least_height(const Facet& facet) {
  if (facet.is_thin()) return kVoxel / 2;
  return facet.body == Body::room ? -kVoxel : 0;
}

std::int64_t dot(const glm::ivec3& a, const glm::ivec3& b) {
  return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y + std::int64_t{a.z} * b.z;
}

// Of the ray's origin over the owner's plane. A gap was rounded down: the middle of what it may be.
std::int64_t height_over(const Ray& ray, const Owned& owned) {
  constexpr int kSixteenth = 1 << (kPlaceFraction - kGapFractionBits);
  return std::int64_t{owned.gap * kSixteenth + kSixteenth / 2} * kNormalOne +
         dot(owned.facet.normal, ray.origin - kPlaceOne * owned.voxel);
}

}  // namespace

std::optional<Face> face(const Ray& ray, const Owned& owned) {
  const Facet& facet = owned.facet;
  if (facet.body == Body::solid && !owned.core) return std::nullopt;
  const std::int64_t leaving = dot(facet.normal, ray.direction);
  if (leaving == 0) return std::nullopt;
  const bool is_back = leaving > 0;
  const bool sees_back = facet.body == Body::sheet || (ray.inside && facet.is_glass());
  const bool sees_front = !(ray.inside && facet.is_glass());
  if (is_back ? !sees_back : !sees_front) return std::nullopt;
  const std::int64_t height = height_over(ray, owned);
  const Face seen = is_back ? Face{-facet.normal, -height, leaving, true}
                            : Face{facet.normal, height, -leaving, false};
  if (seen.height < least_height(facet)) return std::nullopt;
  return seen;
}

Face side_face(const Ray& ray, int axis, std::int64_t way) {
  glm::ivec3 normal(0);
  normal[axis] = ray.direction[axis] < 0 ? kNormalOne : -kNormalOne;
  return {normal, way * kNormalOne, std::int64_t{std::abs(ray.direction[axis])} * kNormalOne,
          ray.inside};
}

bool is_in_front(const Ray& ray, const Owned& owned, int axis, std::int64_t way) {
  return height_over(ray, owned) * std::abs(ray.direction[axis]) +
             dot(owned.facet.normal, ray.direction) * way >
         0;
}

glm::ivec3 meeting_point(const Ray& ray, const Face& face, int n) {
  // Half a unit at most is lost by cutting off the quotient, half by rounding the product.
  const int fraction = direction_fraction(n) + 1;
  const std::int64_t half = std::int64_t{1} << (fraction - 1);
  const std::int64_t farthest = (std::int64_t{1} << meeting_bits(n)) - 1;
  const std::int64_t quotient =
      std::min(farthest, (std::max<std::int64_t>(0, face.height) << fraction) / face.approach);
  // A place beyond this is far outside the cube, and need not fit an int.
  constexpr std::int64_t kFar = 1 << 24;
  glm::ivec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t ahead = (ray.direction[axis] * quotient + half) >> fraction;
    point[axis] = ray.origin[axis] + static_cast<int>(std::clamp(ahead, -kFar, kFar));
  }
  return point;
}

}  // namespace rc2::rays
