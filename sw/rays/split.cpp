#include "sw/rays/split.h"

#include <algorithm>

#include "sw/base/floor_divide.h"

namespace rc2::rays {
namespace {

std::int64_t square_length(const glm::ivec3& v) {
  return std::int64_t{v.x} * v.x + std::int64_t{v.y} * v.y + std::int64_t{v.z} * v.z;
}

// Digit by digit, as a circuit would.
std::int64_t square_root(std::int64_t square) {
  std::int64_t root = 0;
  for (std::int64_t bit = std::int64_t{1} << 31; bit > 0; bit >>= 1)
    if ((root + bit) * (root + bit) <= square) root += bit;
  return root;
}

std::int64_t shift_rounded(std::int64_t value, int bits) {
  return (value + (std::int64_t{1} << (bits - 1))) >> bits;
}

// direction - normal * amount / |normal|^2, the amount in the unit of a face's approach. The
// fraction of the quotient is cut off where it makes half a unit of the result.
glm::ivec3 bend(const glm::ivec3& direction, std::int64_t amount, const glm::ivec3& normal, int n) {
  constexpr int kFraction = kNormalFraction + 1;
  const std::int64_t quotient = floor_divide(amount * (1 << kFraction), square_length(normal));
  const int one = 1 << direction_fraction(n);
  glm::ivec3 bent;
  for (int axis = 0; axis < 3; ++axis) {
    const auto turn = static_cast<int>(shift_rounded(quotient * normal[axis], kFraction));
    bent[axis] = std::clamp(direction[axis] - turn, -one, one);
  }
  return bent;
}

class Sender {
 public:
  Sender(const Ray& parent, const Limits& limits) : parent_(parent), limits_(limits) {}

  // Whether a child with this share of the parent's weight may go; if not, counts why.
  bool may_send(int share) {
    weight_ = static_cast<std::uint16_t>(parent_.weight * share >> kShareFraction);
    if (weight_ == 0 || weight_ < limits_.least_weight) {
      if (share > 0) ++split.too_light;
      return false;
    }
    if (depth_of(parent_.node) >= limits_.depth) {
      ++split.too_deep;
      return false;
    }
    return true;
  }

  Ray child(int side, bool inside, const glm::ivec3& point, const glm::ivec3& direction) const {
    const auto node = static_cast<std::uint8_t>(2 * parent_.node + side);
    return {parent_.home, node, inside, weight_, point, direction};
  }

  Split split;

 private:
  const Ray& parent_;
  const Limits& limits_;
  std::uint16_t weight_ = 0;
};

}  // namespace

glm::ivec3 reflect(const glm::ivec3& direction, const Face& face, int n) {
  return bend(direction, -2 * face.approach, face.normal, n);
}

std::optional<glm::ivec3> refract(const glm::ivec3& direction, const Face& face, int ratio, int n) {
  // With c = -N.d/|N|, r the ratio: (r d - N (sqrt(K) - r c |N|) / |N|^2), K being
  // |N|^2 (1 - r^2 (1 - c^2)). K has 2 kNormalFraction + fraction bits, so its root has enough.
  const int fraction = direction_fraction(n);
  const std::int64_t square = square_length(face.normal) << fraction;
  const std::int64_t sine =
      std::max<std::int64_t>(0, square - (face.approach * face.approach >> fraction));
  const std::int64_t rest = square - ((sine * ratio >> kIndexFraction) * ratio >> kIndexFraction);
  if (rest < 0) return std::nullopt;
  const std::int64_t amount =
      square_root(rest << fraction) - (ratio * face.approach >> kIndexFraction);
  glm::ivec3 scaled;
  for (int axis = 0; axis < 3; ++axis)
    scaled[axis] =
        static_cast<int>(shift_rounded(std::int64_t{ratio} * direction[axis], kIndexFraction));
  return bend(scaled, amount, face.normal, n);
}

Split split(const Ray& ray, const Facet& facet, const Face& face, const glm::ivec3& point,
            const Limits& limits, int n) {
  Sender sender(ray, limits);
  std::optional<glm::ivec3> onwards;
  if (facet.clear > 0) {
    const int ratio = face.is_back ? facet.leave : facet.enter;
    onwards = facet.is_glass() ? refract(ray.direction, face, ratio, n) : ray.direction;
  }
  const int thrown_back = onwards ? 0 : facet.clear;
  if (sender.may_send(std::min<int>(facet.mirror + thrown_back, kShareOne)))
    sender.split.reflected = sender.child(0, ray.inside, point, reflect(ray.direction, face, n));
  if (onwards && sender.may_send(facet.clear))
    sender.split.refracted = sender.child(1, ray.inside != facet.is_glass(), point, *onwards);
  return sender.split;
}

}  // namespace rc2::rays
