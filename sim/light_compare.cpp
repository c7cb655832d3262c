#include "sim/light_compare.h"

#include <glm/common.hpp>

namespace rc2 {
namespace {

using truth::Verdict;

bool belongs(const Verdict& verdict, Population population) {
  if (population == Population::exposed) return verdict.exposed;
  return verdict.faces_light && (population == Population::facing || verdict.seen);
}

bool truly_lit(const Verdict& verdict, Population population) {
  return population == Population::exposed ? verdict.lit : verdict.facing_are_lit;
}

}  // namespace

const char* to_string(Population population) {
  switch (population) {
    case Population::facing:
      return "facing";
    case Population::exposed:
      return "exposed";
    case Population::seen:
      return "seen";
  }
  return "unknown";
}

void Errors::add(const Errors& other) {
  voxels += other.voxels;
  dark += other.dark;
  lit += other.lit;
  dark_tolerant += other.dark_tolerant;
  lit_tolerant += other.lit_tolerant;
}

Shown::Shown(const LayerMemory& layers, const VoxelMemory& voxels, int n)
    : n_(n), index_(static_cast<std::size_t>(n) * n * n, kNone) {
  std::size_t number = 0;
  for (const LayerRecord& layer : layers) {
    if (!layer.armour) continue;
    if (layer.shown) {
      index_[place(layer.at)] = static_cast<std::uint32_t>(at_.size());
      at_.push_back(layer.at);
      owners_.push_back(voxels[number].owner.facet);
      numbers_.push_back(number);
    }
    ++number;
  }
}

template <class Holds>
bool Shown::any_neighbour(std::size_t i, Holds holds) const {
  const glm::ivec3 lo = glm::max(at_[i] - 1, 0), hi = glm::min(at_[i] + 1, n_ - 1);
  for (glm::ivec3 at = lo; at.z <= hi.z; ++at.z) {
    for (at.y = lo.y; at.y <= hi.y; ++at.y) {
      for (at.x = lo.x; at.x <= hi.x; ++at.x) {
        const std::uint32_t other = index_[place(at)];
        if (other != kNone && other != i && holds(other)) return true;
      }
    }
  }
  return false;
}

Errors Shown::compare(const std::vector<Verdict>& verdicts, Population population,
                      const LightMemory& arrived, const std::vector<bool>& away) const {
  Errors errors;
  for (std::size_t i = 0; i < at_.size(); ++i) {
    if (!belongs(verdicts[i], population)) continue;
    ++errors.voxels;
    const bool is_shaded = population == Population::exposed && away[owners_[i]];
    const bool lit = arrived[numbers_[i]] > 0 && !is_shaded;
    if (lit == truly_lit(verdicts[i], population)) continue;
    const bool is_excused = any_neighbour(i, [&](std::uint32_t other) {
      return belongs(verdicts[other], population) && truly_lit(verdicts[other], population) == lit;
    });
    ++(lit ? errors.lit : errors.dark);
    if (!is_excused) ++(lit ? errors.lit_tolerant : errors.dark_tolerant);
  }
  return errors;
}

}  // namespace rc2
