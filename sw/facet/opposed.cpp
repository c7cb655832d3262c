#include "sw/facet/opposed.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/ext/vector_int3_sized.hpp>

#include "sw/facet/box_tree.h"

namespace rc2::facet {
namespace {

__extension__ using Wide = __int128;

constexpr int kOpposite = 26;  // the sum of two opposite ways to face

// What the slab asks of a voxel p: least <= normal . p <= least + width.
struct Level {
  glm::i64vec3 normal;
  std::int64_t size;  // largest component of the normal
  Wide least, width;

  explicit Level(const PacketHead& packet)
      : normal(packet.slab.value.a, packet.slab.value.b, packet.slab.value.c),
        least(-packet.slab.value.d),
        width(packet.slab.width) {
    const glm::i64vec3 sizes = glm::abs(normal);
    size = std::max({sizes.x, sizes.y, sizes.z});
    for (int axis = 0; axis < 3; ++axis) least += Wide(normal[axis]) * packet.lo[axis];
  }
};

// Adds the two slabs' conditions, weighted so that opposite normals cancel: what is left hardly
// depends on the voxel and says how far the planes are apart.
bool may_meet(const PacketHead& a, const PacketHead& b) {
  const Level level_a(a), level_b(b);
  Wide low = 0, high = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Wide slope =
        Wide(level_a.normal[axis]) * level_b.size + Wide(level_b.normal[axis]) * level_a.size;
    const int first = std::max(a.lo[axis], b.lo[axis]), last = std::min(a.hi[axis], b.hi[axis]);
    low += slope * (slope < 0 ? last : first);
    high += slope * (slope < 0 ? first : last);
  }
  const Wide least = level_a.least * level_b.size + level_b.least * level_a.size;
  const Wide width = level_a.width * level_b.size + level_b.width * level_a.size;
  return low <= least + width && least <= high;
}

}  // namespace

int facing(const Vertex& normal) {
  const std::int64_t size = std::abs(normal[dominant_axis(normal)]);
  int code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_large = 12 * std::abs(normal[axis]) >= 5 * size;
    code = 3 * code + (is_large ? (normal[axis] < 0 ? 0 : 2) : 1);
  }
  return code;
}

std::vector<std::uint32_t> find_opposed(const std::vector<PacketHead>& packets) {
  std::array<std::vector<std::uint32_t>, kOpposite + 1> by_facing;
  for (std::uint32_t i = 0; i < packets.size(); ++i) {
    if (packets[i].surface == Surface::crowd) continue;
    const Linear& plane = packets[i].slab.value;
    by_facing[static_cast<std::size_t>(facing({plane.a, plane.b, plane.c}))].push_back(i);
  }
  std::vector<bool> is_opposed(packets.size());
  for (std::size_t way = 0; way < kOpposite / 2; ++way) {
    const std::vector<std::uint32_t>& others = by_facing[kOpposite - way];
    if (by_facing[way].empty() || others.empty()) continue;
    std::vector<Box> boxes;
    boxes.reserve(others.size());
    for (const std::uint32_t other : others)
      boxes.emplace_back(packets[other].lo, packets[other].hi);
    const BoxTree tree(boxes);
    for (const std::uint32_t i : by_facing[way]) {
      // All that meet, because each of them has to be marked, too.
      tree.query({packets[i].lo, packets[i].hi}, [&](std::uint32_t place) {
        const std::uint32_t other = others[place];
        if (is_opposed[i] && is_opposed[other]) return;
        if (may_meet(packets[i], packets[other])) is_opposed[i] = is_opposed[other] = true;
      });
    }
  }
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < packets.size(); ++i)
    if (is_opposed[i]) result.push_back(i);
  return result;
}

}  // namespace rc2::facet
