#include "sw/surface/rounding.h"

#include <algorithm>
#include <cstdlib>

#include "sw/base/floor_divide.h"

namespace rc2::surface {
namespace {

__extension__ using Wide = __int128;
using facet::Vertex;

std::int64_t quotient(Wide numerator, Wide denominator) {
  return static_cast<std::int64_t>(floor_divide(numerator, denominator));
}

Wide wide_dot(const Vertex& a, const Vertex& b) {
  return Wide(a.x) * b.x + Wide(a.y) * b.y + Wide(a.z) * b.z;
}

struct Range {
  Wide low, high;
};

// r.q, q counted from the box's low corner like everything in a packet. At the centroid it is
// rounded to an integer: 1 / (K M) of a voxel is far less than what the exact slab's own integers
// left out.
Range loss(const Vertex& r, const facet::PacketHead& head, const Mesh& mesh, Rounding rounding) {
  if (rounding == Rounding::widened) {
    Range range{0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      const Wide at_end = Wide(r[axis]) * (head.hi[axis] - head.lo[axis]);
      (at_end < 0 ? range.low : range.high) += at_end;
    }
    return range;
  }
  const Wide to_corner = wide_dot(r, Vertex(head.lo));
  Wide from_origin = 0;
  if (rounding == Rounding::centroid) {
    const facet::Border& border = mesh.facets[head.facet];
    Vertex sum(0);
    for (const Vertex& vertex : border) sum += vertex;
    from_origin = quotient(wide_dot(r, sum), Wide(border.size()) << mesh.fraction_bits);
  }
  return {from_origin - to_corner, from_origin - to_corner};
}

}  // namespace

const char* to_string(Rounding rounding) {
  constexpr const char* kNames[] = {"origin", "centroid", "widened"};
  return kNames[static_cast<std::size_t>(rounding)];
}

facet::PacketStream round_slabs(const facet::PacketStream& exact, const Mesh& mesh, int bits,
                                Rounding rounding) {
  const std::int64_t largest = (std::int64_t{1} << (bits - 1)) - 1;  // M
  facet::PacketStream stream = exact;
  for (facet::PacketHead& head : stream.heads) {
    facet::Linear& value = head.slab.value;
    const Vertex normal(value.a, value.b, value.c);
    const std::int64_t size = std::abs(normal[facet::dominant_axis(normal)]);  // K
    if (size <= largest) continue;
    Vertex rounded, r;
    for (int axis = 0; axis < 3; ++axis) {
      const Wide scaled = Wide(normal[axis]) * largest;
      rounded[axis] = quotient(2 * scaled + size, Wide(2) * size);
      r[axis] = static_cast<std::int64_t>(Wide(rounded[axis]) * size - scaled);
    }
    const Range range = loss(r, head, mesh, rounding);
    const Wide back = value.d, front = head.slab.width - value.d;
    value = {rounded.x, rounded.y, rounded.z, quotient(back * largest - range.low, size)};
    // What marks the inside has no front.
    if (head.layer != facet::Layer::inside)
      head.slab.width = value.d + quotient(front * largest + range.high, size);
  }
  return stream;
}

}  // namespace rc2::surface
