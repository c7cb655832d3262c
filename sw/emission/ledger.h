// What a way of finding out what a light reaches costs, counted as the thesis counts (4.1, 4.2).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sw/golden/grid.h"

namespace rc2::emission {

struct Cost {
  std::int64_t rays = 0;      ///< sent, answers included (4.1.6)
  std::int64_t visits = 0;    ///< voxels that rays or beams came to
  std::int64_t messages = 0;  ///< from cell to cell
  std::int64_t busiest = 0;   ///< visits of the cell with the most: the cycles that it needs
};

/// An occupied voxel ends every ray that comes to it (4.1.4).
class Ledger {
 public:
  /// `grid` holds the numbers of its occupied voxels, 0 .. occupied - 1.
  Ledger(const golden::Grid& grid, std::size_t occupied);

  int n() const { return grid_.n(); }
  bool contains(const glm::ivec3& voxel) const {
    return grid_[grid_.index(voxel)] != golden::Grid::kOutside;
  }
  /// Of a voxel of the cube.
  bool is_free(const glm::ivec3& voxel) const {
    return grid_[grid_.index(voxel)] == golden::Grid::kFree;
  }

  void send(std::int64_t rays) { cost_.rays += rays; }

  /// A ray or beam goes on from a voxel to one of its neighbours, in the same cell or in another.
  void move(const glm::ivec3& from, const glm::ivec3& to);

  /// An answer from cell to cell. Any way will do (4.1.3), the array has links to eight neighbours,
  /// and routers pass it on: no cell has to look at it.
  void answer(const glm::ivec3& from, const glm::ivec3& to);

  void light(const glm::ivec3& voxel) { lit_[grid_[grid_.index(voxel)]] = true; }

  /// Of each occupied voxel, by its number.
  const std::vector<bool>& lit() const { return lit_; }

  /// Free voxels that nothing came to; the source is one of them.
  std::int64_t untouched() const;

  const Cost& cost() const { return cost_; }

 private:
  const golden::Grid& grid_;
  std::vector<std::int64_t> visits_;  // of each cell
  std::vector<bool> touched_;         // by place in the grid
  std::vector<bool> lit_;
  Cost cost_;
};

}  // namespace rc2::emission
