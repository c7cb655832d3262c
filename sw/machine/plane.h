// The plane of a voxel's owner, as a machine keeps it beside the claim.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "sw/base/config.h"
#include "sw/facet/packet.h"

namespace rc2 {

/// What a gap rises by in one voxel along an axis, rounded to normal_fraction_bits(n).
constexpr int normal_part(std::int64_t rise) { return static_cast<int>((rise + 2) >> 2); }

/// What a packet's gap says of its facet's plane: N / K with normal_fraction_bits(n).
inline glm::ivec3 normal_of(const facet::Linear& gap) {
  return {normal_part(gap.a), normal_part(gap.b), normal_part(gap.c)};
}

}  // namespace rc2
