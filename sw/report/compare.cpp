#include "sw/report/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace rc2::report {
namespace {

using Value = std::optional<std::int64_t>;

bool before(glm::ivec3 a, glm::ivec3 b) {
  return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
}

Value light_at(const Memories& memories, std::size_t light, std::size_t voxel) {
  if (light >= memories.lights.size()) return std::nullopt;
  return memories.lights[light][voxel];
}

class Comparer {
 public:
  Comparer(const Memories& expected, const Memories& got) : expected_(expected), got_(got) {}

  Comparison run() {
    std::size_t e = 0, g = 0;
    const VoxelMemory &left = expected_.voxels, &right = got_.voxels;
    while (e < left.size() || g < right.size()) {
      if (g == right.size() || (e < left.size() && before(left[e].at, right[g].at))) {
        note(result_.voxels_differing, left[e].at, "facet", left[e].owner.facet, std::nullopt);
        ++e;
      } else if (e == left.size() || before(right[g].at, left[e].at)) {
        note(result_.voxels_differing, right[g].at, "facet", std::nullopt, right[g].owner.facet);
        ++g;
      } else {
        compare_voxel(e++, g++);
      }
    }
    return std::move(result_);
  }

 private:
  void compare_voxel(std::size_t e, std::size_t g) {
    const glm::ivec3 at = expected_.voxels[e].at;
    const Claim &left = expected_.voxels[e].owner, &right = got_.voxels[g].owner;
    if (left.facet != right.facet) {
      note(result_.owners_differing, at, "facet", left.facet, right.facet);
    } else if (left.core != right.core) {
      note(result_.owners_differing, at, "core", left.core ? 1 : 0, right.core ? 1 : 0);
    } else if (left.gap != right.gap) {
      note(result_.owners_differing, at, "gap", left.gap, right.gap);
    }
    const std::size_t lights = std::max(expected_.lights.size(), got_.lights.size());
    for (std::size_t k = 0; k < lights; ++k) {
      const Value want = light_at(expected_, k, e), have = light_at(got_, k, g);
      if (want != have) {
        note(result_.lights_differing, at, fmt::format("light{}", k), want, have);
      }
    }
  }

  void note(std::int64_t& count, glm::ivec3 at, const std::string& what, Value want, Value have) {
    ++count;
    if (result_.first.size() < kFirstDifferences) result_.first.push_back({at, what, want, have});
  }

  const Memories &expected_, &got_;
  Comparison result_;
};

}  // namespace

Comparison compare(const Memories& expected, const Memories& got) {
  return Comparer(expected, got).run();
}

std::string to_string(const Difference& difference) {
  const auto word = [](const Value& value) { return value ? std::to_string(*value) : "none"; };
  return fmt::format("voxel ({},{},{}), {}: expected {}, got {}", difference.at.x, difference.at.y,
                     difference.at.z, difference.what, word(difference.expected),
                     word(difference.got));
}

}  // namespace rc2::report
