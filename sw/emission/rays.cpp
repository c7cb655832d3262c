#include "sw/emission/rays.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <glm/common.hpp>

#include "sw/lines/digital_line.h"

namespace rc2::emission {
namespace {

int largest(const glm::ivec3& way) {
  const glm::ivec3 size = glm::abs(way);
  return std::max({size.x, size.y, size.z});
}

// Bresenham's line, one voxel after another.
class Line {
 public:
  explicit Line(const glm::ivec3& way)
      : axes_{lines::DigitalLine(way.x, largest(way)), lines::DigitalLine(way.y, largest(way)),
              lines::DigitalLine(way.z, largest(way))} {}

  glm::ivec3 step() { return {axes_[0].advance(), axes_[1].advance(), axes_[2].advance()}; }

 private:
  std::array<lines::DigitalLine, 3> axes_;
};

// Where the ray ends: at `target`, in the first occupied voxel, or in the last one of the cube.
glm::ivec3 follow(Ledger& ledger, const glm::ivec3& from, const glm::ivec3& target) {
  ledger.send(1);
  Line line(target - from);
  glm::ivec3 at = from;
  while (at != target) {
    const glm::ivec3 next = at + line.step();
    if (!ledger.contains(next)) break;
    ledger.move(at, next);
    at = next;
    if (!ledger.is_free(at)) break;
  }
  return at;
}

void send(Ledger& ledger, const glm::ivec3& source, const glm::ivec3& target) {
  if (target == source) return;
  const glm::ivec3 end = follow(ledger, source, target);
  if (!ledger.is_free(end)) ledger.light(end);
}

// Calls visit(voxel) for all of low .. high in each coordinate, or for those on the surface only.
template <typename Visit>
void for_box(const glm::ivec3& low, const glm::ivec3& high, bool surface_only, Visit visit) {
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      const bool is_rim = z == low.z || z == high.z || y == low.y || y == high.y;
      const int step = is_rim || !surface_only ? 1 : std::max(1, high.x - low.x);
      for (int x = low.x; x <= high.x; x += step) visit(glm::ivec3(x, y, z));
    }
  }
}

}  // namespace

void ask_light(Ledger& ledger, const std::vector<glm::ivec3>& voxels, const glm::ivec3& source) {
  for (const glm::ivec3& voxel : voxels) {
    const glm::ivec3 end = follow(ledger, voxel, source);
    ledger.answer(end, voxel);
    if (end == source) ledger.light(voxel);
  }
}

void send_one_by_one(Ledger& ledger, Targets targets, const glm::ivec3& source) {
  const int last = ledger.n() - 1;
  const bool is_virtual = targets == Targets::virtual_;
  const glm::ivec3 low = is_virtual ? source - last : glm::ivec3(0);
  const glm::ivec3 high = is_virtual ? source + last : glm::ivec3(last);
  for_box(low, high, targets != Targets::voxels,
          [&](const glm::ivec3& target) { send(ledger, source, target); });
}

}  // namespace rc2::emission
