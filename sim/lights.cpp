#include "sim/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "sw/machine/find_voxel.h"

namespace rc2 {
namespace {

bool inside(const glm::dvec3& at, int n) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(at[axis] >= 0 && at[axis] <= n - 1)) return false;
  }
  return true;
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ',') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

template <typename Number>
std::optional<Number> parse(const std::string& word) {
  Number value{};
  const char* end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, value);
  if (failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

Lamp parse_lamp(const std::string& text, int n) {
  const auto refuse = [&](const std::string& why) {
    throw Error(fmt::format("--light {}: {}", text, why));
  };
  const std::vector<std::string> words = split_at_commas(text);
  if (words.size() != 3 && words.size() != 6) {
    refuse(fmt::format("a light has 3 or 6 numbers, not {}; write x,y,z or x,y,z,r,g,b",
                       words.size()));
  }
  Lamp lamp{"--light " + text, {}, glm::vec3(1)};
  for (int i = 0; i < 3; ++i) {
    const std::string& word = words[static_cast<std::size_t>(i)];
    const auto value = parse<int>(word);
    if (!value || *value < 0 || *value >= n) {
      refuse(fmt::format("'{}' is not a voxel coordinate; write whole numbers from 0 to {}", word,
                         n - 1));
    }
    lamp.voxel[i] = *value;
  }
  for (int i = 0; i < 3 && words.size() == 6; ++i) {
    const std::string& word = words[3 + static_cast<std::size_t>(i)];
    const auto value = parse<float>(word);
    if (!value || !std::isfinite(*value) || *value < 0) {
      refuse(
          fmt::format("'{}' is not a part of a colour; write three numbers that are not "
                      "negative, 1,1,1 is white",
                      word));
    }
    lamp.colour[i] = *value;
  }
  return lamp;
}

}  // namespace

// Looks at ever larger boxes around the place; a box of half side r holds all voxels at most r
// away.
std::optional<glm::ivec3> nearest_free(const VoxelMemory& voxels, glm::ivec3 place, int n) {
  std::optional<glm::ivec3> best;
  int best_square = 0;
  for (int r = 0; r < n && !(best && best_square <= r * r); ++r) {
    const glm::ivec3 lo = glm::max(place - r, glm::ivec3(0));
    const glm::ivec3 hi = glm::min(place + r, glm::ivec3(n - 1));
    for (glm::ivec3 at = lo; at.z <= hi.z; ++at.z) {
      for (at.y = lo.y; at.y <= hi.y; ++at.y) {
        for (at.x = lo.x; at.x <= hi.x; ++at.x) {
          const glm::ivec3 away = at - place;
          const int square = away.x * away.x + away.y * away.y + away.z * away.z;
          if ((best && square >= best_square) || find_voxel(voxels, at) != nullptr) continue;
          best = at;
          best_square = square;
        }
      }
    }
  }
  return best;
}

Lamps choose_lamps(const std::vector<std::string>& asked, const scene::Scene& scene, int n) {
  Lamps lamps;
  for (const std::string& text : asked) lamps.list.push_back(parse_lamp(text, n));
  lamps.counts.read = static_cast<std::int64_t>(asked.size());
  if (asked.empty()) {
    lamps.counts.read = static_cast<std::int64_t>(scene.lights.size());
    for (const scene::Light& light : scene.lights) {
      const glm::dvec3 nearest = glm::floor(light.position + 0.5);
      if (inside(nearest, n)) {
        lamps.list.push_back({"a light of " + scene.name, glm::ivec3(nearest), light.colour});
      } else {
        ++lamps.counts.outside;
      }
    }
  }
  lamps.counts.used = static_cast<std::int64_t>(lamps.list.size());
  return lamps;
}

void place_lamps(Lamps& lamps, const VoxelMemory& voxels, int n) {
  if (lamps.list.empty()) {
    const auto voxel = nearest_free(voxels, {n / 4, 3 * n / 4, n - 1}, n);
    if (!voxel) throw Error("every voxel is occupied, so no light can be placed; use a larger --n");
    lamps.list.push_back({"the default light", *voxel, glm::vec3(1)});
    lamps.counts.used = 1;
    lamps.counts.by_default = true;
  }
  for (const Lamp& lamp : lamps.list) {
    const VoxelRecord* occupied = find_voxel(voxels, lamp.voxel);
    if (occupied == nullptr) continue;
    const auto free = nearest_free(voxels, lamp.voxel, n);
    throw Error(fmt::format(
        "{}: its voxel ({},{},{}) is occupied by facet {}; move it, for example with {}",
        lamp.origin, lamp.voxel.x, lamp.voxel.y, lamp.voxel.z, occupied->owner.facet,
        free ? fmt::format("--light {},{},{}", free->x, free->y, free->z) : "a larger --n"));
  }
}

std::vector<picture::Lamp> lit_lamps(const std::vector<Lamp>& lamps,
                                     const std::vector<LightMemory>& arrived) {
  std::vector<picture::Lamp> lit;
  for (std::size_t k = 0; k < lamps.size(); ++k)
    lit.push_back({lamps[k].voxel, lamps[k].colour, arrived[k]});
  return lit;
}

}  // namespace rc2
