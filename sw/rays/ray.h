// What travels: rays and what they meet.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sw/rays/format.h"

namespace rc2::rays {

/// What a facet belongs to.
enum class Body : std::uint8_t {
  solid,  ///< a closed surface round matter: seen from outside; from inside, if it is glass
  room,   ///< a closed surface round air: seen from its outer side only, which faces inwards
  sheet   ///< a surface that is not closed: seen from both sides
};

/// What a voxel knows of its owner beside the claim: light is reflected and refracted by this.
struct Facet {
  glm::ivec3 normal{0, 0, kNormalOne};  ///< outward; its largest component is kNormalOne
  std::uint16_t mirror = 0, clear = 0;  ///< shares reflected and let through, of kShareOne
  /// Refractive index outside over that inside, and the inverse.
  std::uint16_t enter = kIndexOne, leave = kIndexOne;
  Body body = Body::solid;

  bool is_glass() const { return body == Body::solid && clear > 0; }
  /// Has no matter behind it.
  bool is_thin() const { return body == Body::sheet || (body == Body::room && clear > 0); }
};

/// A ray at its start.
struct Ray {
  glm::ivec2 home;        ///< the pixel that it is for
  std::uint8_t node = 1;  ///< of the pixel's tree: 2i reflected by, 2i+1 let through i
  bool inside = false;    ///< in glass
  std::uint16_t weight = kWeightOne;
  glm::ivec3 origin;     ///< 1/64 voxel
  glm::ivec3 direction;  ///< unit vector, direction_fraction(n) fraction bits
};

/// Bounces on the way from the viewer.
constexpr int depth_of(std::uint8_t node) { return bits_for(node + 1LL) - 1; }

/// The voxel coordinate that a place belongs to: nearest, the larger one of two.
constexpr int voxel_of(int place) { return (place + kPlaceOne / 2) >> kPlaceFraction; }

inline glm::ivec3 voxel_of(const glm::ivec3& place) {
  return {voxel_of(place.x), voxel_of(place.y), voxel_of(place.z)};
}

/// How far along an axis a ray has gone when it leaves a voxel of that coordinate, 1/64 voxel.
inline std::int64_t exit_distance(const Ray& ray, int axis, int voxel) {
  const int ahead = kPlaceOne * voxel - ray.origin[axis];
  return (ray.direction[axis] < 0 ? -ahead : ahead) + kPlaceOne / 2;
}

/// The nearest place in the voxel, or in those round it that are at most `around` away.
inline glm::ivec3 clamp_to_voxel(const glm::ivec3& place, const glm::ivec3& voxel, int around = 0) {
  const glm::ivec3 low = kPlaceOne * (voxel - around) - kPlaceOne / 2;
  return glm::clamp(place, low, low + kPlaceOne * (2 * around + 1) - 1);
}

}  // namespace rc2::rays
