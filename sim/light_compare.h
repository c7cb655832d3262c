// Where the light of a machine differs from the truth, counted over sets of voxels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sw/machine/machine.h"
#include "sw/truth/verdict.h"

namespace rc2 {

/// A set of shown voxels, and what is compared in it.
enum class Population {
  facing,   ///< face the light: whether light arrives
  exposed,  ///< any that are not inside a solid: whether light arrives and the owner faces it
  seen      ///< face the light and are seen by the viewer: whether light arrives
};
inline constexpr std::array kPopulations{Population::facing, Population::exposed, Population::seen};

const char* to_string(Population population);

/// Voxels that are dark but lit in truth, and the other way round. Tolerant: those of them that
/// have no voxel of the same population next to them for which it would be right.
struct Errors {
  std::int64_t voxels = 0;
  std::int64_t dark = 0, lit = 0;
  std::int64_t dark_tolerant = 0, lit_tolerant = 0;

  void add(const Errors& other);
  double percent(std::int64_t count) const {
    return voxels == 0 ? 0 : 100.0 * static_cast<double>(count) / static_cast<double>(voxels);
  }
};

/// The shown voxels of a machine.
class Shown {
 public:
  Shown(const LayerMemory& layers, const VoxelMemory& voxels, int n);

  const std::vector<glm::ivec3>& places() const { return at_; }

  /// Of each of the places its number in VoxelMemory.
  const std::vector<std::size_t>& numbers() const { return numbers_; }

  /// `verdicts` in the order of places(); `arrived` as the machine read it; `away`: of each facet,
  /// whether it turns away from the light.
  Errors compare(const std::vector<truth::Verdict>& verdicts, Population population,
                 const LightMemory& arrived, const std::vector<bool>& away) const;

 private:
  static constexpr std::uint32_t kNone = ~0U;

  std::size_t place(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * n_ + at.y) * n_ + at.x;
  }

  /// Whether holds(i) for any of the up to 26 neighbours i.
  template <class Holds>
  bool any_neighbour(std::size_t i, Holds holds) const;

  int n_;
  std::vector<std::uint32_t> index_;  // of all voxels of the cube
  std::vector<glm::ivec3> at_;
  std::vector<std::uint32_t> owners_;
  std::vector<std::size_t> numbers_;  // in the order of VoxelMemory
};

}  // namespace rc2
