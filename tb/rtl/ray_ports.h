// Rays at the ports of a Verilated module, and facets that are awkward for them.
#pragma once

#include <cstring>
#include <vector>

#include "sw/rays/face.h"
#include "sw/rays/split.h"
#include "tb/rtl/block.h"
#include "tb/unit/random_rays.h"

namespace rc2::tb {

constexpr int kSide = RC2_N;  // of the module that is tested
#define RC2_RAY_DEPTH 4       // bounces that it is built for, rtl/rc2_pkg.sv

/// A field of a packed struct.
struct Field {
  std::int64_t value;
  int width;
};

/// Puts fields, the highest first, into a port of any width.
template <class Port>
void set_fields(Port& port, const std::vector<Field>& fields) {
  std::uint64_t limbs[8] = {};
  int at = 0;
  for (auto field = fields.rbegin(); field != fields.rend(); ++field) {
    for (int bit = 0; bit < field->width; ++bit, ++at)
      limbs[at / 64] |= static_cast<std::uint64_t>(field->value >> bit & 1) << at % 64;
  }
  std::memcpy(static_cast<void*>(&port), limbs, sizeof port);
}

/// `width` bits of a port from bit `at` on, as a number with a sign or without.
template <class Port>
std::int64_t field_of(const Port& port, int at, int width, bool has_sign = true) {
  std::uint64_t limbs[8] = {};
  std::memcpy(limbs, static_cast<const void*>(&port), sizeof port);
  std::int64_t value = 0;
  for (int bit = 0; bit < width; ++bit)
    value |= static_cast<std::int64_t>(limbs[(at + bit) / 64] >> (at + bit) % 64 & 1) << bit;
  return has_sign && (value >> (width - 1) & 1) != 0 ? value - (std::int64_t{1} << width) : value;
}

/// The fields of a port one after another, the lowest first.
class FieldsFromBelow {
 public:
  template <class Port>
  explicit FieldsFromBelow(const Port& port) {
    std::memcpy(limbs_, static_cast<const void*>(&port), sizeof port);
  }
  void skip(int width) { at_ += width; }
  std::int64_t take(int width, bool has_sign = true) {
    at_ += width;
    return field_of(limbs_, at_ - width, width, has_sign);
  }

 private:
  std::uint64_t limbs_[8] = {};
  int at_ = 0;
};

/// Three fields of equal width, z the lowest.
inline glm::ivec3 take_place(FieldsFromBelow& fields, int width) {
  glm::ivec3 place;
  for (int axis = 2; axis >= 0; --axis) place[axis] = static_cast<int>(fields.take(width));
  return place;
}

template <class Top>
void set_ray(Top& top, const rays::Ray& ray) {
  const int place = rays::place_bits(kSide), direction = rays::direction_bits(kSide);
  set_fields(top.ox_i, {{ray.origin.x, place}});
  set_fields(top.oy_i, {{ray.origin.y, place}});
  set_fields(top.oz_i, {{ray.origin.z, place}});
  set_fields(top.dx_i, {{ray.direction.x, direction}});
  set_fields(top.dy_i, {{ray.direction.y, direction}});
  set_fields(top.dz_i, {{ray.direction.z, direction}});
}

/// A facet of any body; one in three has a normal along an axis or a diagonal.
inline rays::Facet random_facet(scene::Random& random) {
  rays::Facet facet;
  const bool is_even = random.below(3) == 0;
  for (int axis = 0; axis < 3; ++axis)
    facet.normal[axis] = is_even ? rays::kNormalOne * (random.below(3) - 1)
                                 : random.below(2 * rays::kNormalOne + 1) - rays::kNormalOne;
  facet.normal[random.below(3)] = random.below(2) == 0 ? rays::kNormalOne : -rays::kNormalOne;
  facet.mirror = static_cast<std::uint16_t>(random.below(rays::kShareOne + 1));
  if (random.below(2) == 0)
    facet.clear = static_cast<std::uint16_t>(rays::kShareOne - facet.mirror);
  facet.enter = static_cast<std::uint16_t>(random.below(rays::kMaxIndex * rays::kIndexOne + 1));
  facet.leave = static_cast<std::uint16_t>(random.below(rays::kMaxIndex * rays::kIndexOne + 1));
  facet.body = static_cast<rays::Body>(random.below(3));
  return facet;
}

/// Of any length up to that of all components one; one in four grazing an axis.
inline rays::Ray any_ray(scene::Random& random) {
  rays::Ray ray = random_ray(random, kSide);
  if (random.below(4) == 0)
    for (int axis = 0; axis < 3; ++axis)
      ray.direction[axis] = (random.below(3) - 1) * (1 << rays::direction_fraction(kSide));
  if (ray.direction == glm::ivec3(0)) ray.direction.z = -1;
  if (random.below(4) == 0) ray.direction[random.below(3)] = random.below(3) - 1;
  return ray;
}

constexpr int kHeightBits = rays::height_bits(kSide);
constexpr int kApproachBits = rays::direction_fraction(kSide) + rays::kNormalFraction + 2;
constexpr int kShareBits = 9, kIndexBits = 15, kWeightBits = 13;
constexpr int kFaceBits = 3 * rays::kNormalBits + kHeightBits + kApproachBits + 2 + kFacetBits +
                          2 * kShareBits + kIndexBits;

/// rc2_pkg::start_t.
inline std::vector<Field> start_fields(const rays::Ray& ray) {
  const int at = coordinate_bits(kSide), place = rays::place_bits(kSide),
            direction = rays::direction_bits(kSide);
  return {{ray.home.x, at},
          {ray.home.y, at},
          {ray.node, RC2_RAY_DEPTH + 1},
          {ray.inside ? 1 : 0, 1},
          {ray.weight, kWeightBits},
          {ray.origin.x, place},
          {ray.origin.y, place},
          {ray.origin.z, place},
          {ray.direction.x, direction},
          {ray.direction.y, direction},
          {ray.direction.z, direction}};
}

}  // namespace rc2::tb
