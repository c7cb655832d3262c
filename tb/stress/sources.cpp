#include "tb/stress/sources.h"

#include <array>
#include <glm/common.hpp>

#include "sw/machine/checks.h"

namespace rc2::stress {
namespace {

constexpr int kTries = 200;
// In larger cubes the largest L would take all the time: rays come to a voxel in thousands of ways.
constexpr int kLargestSideOfAllL = 17;

glm::ivec3 random_voxel(int n, Dice& dice) {
  const auto x = static_cast<int>(dice.roll(0, n - 1)), y = static_cast<int>(dice.roll(0, n - 1));
  return {x, y, static_cast<int>(dice.roll(0, n - 1))};
}

// With so many coordinates at an end.
glm::ivec3 voxel_at_border(int n, int ends, Dice& dice) {
  glm::ivec3 at = random_voxel(n, dice);
  const auto first = static_cast<int>(dice.roll(0, 2));
  for (int i = 0; i < ends; ++i) at[(first + i) % 3] = dice.one_in(2) ? 0 : n - 1;
  return at;
}

bool is_beside_armour(const LightOracle& oracle, int n, const glm::ivec3& at) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int step : {-1, 1}) {
      glm::ivec3 other = at;
      other[axis] += step;
      if (glm::clamp(other, 0, n - 1) == other && oracle.is_armoured(other)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::pair<const char*, glm::ivec3>> choose_sources(const LightOracle& oracle, int n,
                                                               Dice& dice) {
  std::vector<std::pair<const char*, glm::ivec3>> sources;
  const auto choose = [&](const char* place, int ends, const auto& suits) {
    for (int tries = 0; tries < kTries; ++tries) {
      const glm::ivec3 at = voxel_at_border(n, ends, dice);
      if (oracle.is_armoured(at) || !suits(at)) continue;
      sources.emplace_back(place, at);
      return;
    }
  };
  const auto any = [](const glm::ivec3&) { return true; };
  choose("a corner of the cube", 3, any);
  choose("an edge of the cube", 2, any);
  choose("a face of the cube", 1, any);
  choose("beside a facet", 0,
         [&](const glm::ivec3& at) { return is_beside_armour(oracle, n, at); });
  choose("inside a solid", 0, [&](const glm::ivec3& at) { return oracle.is_inside(at); });
  choose("anywhere", 0, any);
  return sources;
}

std::pair<std::string, int> draw_distance(int n, Dice& dice) {
  const std::array<std::pair<const char*, int>, 11> all{{{"1", 1},
                                                         {"2", 2},
                                                         {"3", 3},
                                                         {"n - 1", n - 1},
                                                         {"n", n},
                                                         {"n + 1", n + 1},
                                                         {"2n", 2 * n},
                                                         {"4n - 1", 4 * n - 1},
                                                         {"8n - 1", 8 * n - 1},
                                                         {"8n", 8 * n},
                                                         {"32767", kMaxDistance}}};
  const std::size_t last = n <= kLargestSideOfAllL ? all.size() - 1 : all.size() - 4;
  return all[static_cast<std::size_t>(dice.roll(0, static_cast<std::int64_t>(last)))];
}

}  // namespace rc2::stress
