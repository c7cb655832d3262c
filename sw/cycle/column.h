// The voxel and illumination memories of all columns (rtl/rc2_column.sv).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rc2::cycle {

/// Column c is that of cell y*n + x. Only occupied voxels have an owner and a count, so only they
/// take memory: they are listed in order of z, and a voxel's place is the number of occupied voxels
/// below it.
class Columns {
 public:
  explicit Columns(int n);

  /// n*n.
  std::size_t size() const { return voxels_.size(); }

  bool occupied(std::size_t column, int z) const {
    return (occupied_[word_of(column, z)] >> (z % 64) & 1U) != 0;
  }

  /// Forgets all voxels.
  void clear();

  /// Gives a voxel to a facet; of several facets the lowest number keeps it.
  void fill(std::size_t column, int z, std::uint32_t facet);

  /// Forgets the light.
  void darken();

  /// Counts targets that arrive at an occupied voxel.
  void absorb(std::size_t column, int z, std::int64_t targets) {
    voxels_[column][place(column, z)].arrived += static_cast<std::uint32_t>(targets);
  }

  std::uint32_t owner(std::size_t column, int z) const {
    return voxels_[column][place(column, z)].owner;
  }
  std::uint32_t arrived(std::size_t column, int z) const {
    return voxels_[column][place(column, z)].arrived;
  }

 private:
  struct Voxel {
    std::uint32_t owner, arrived;
  };

  std::size_t word_of(std::size_t column, int z) const {
    return column * words_ + static_cast<std::size_t>(z) / 64;
  }
  std::size_t place(std::size_t column, int z) const;

  std::size_t words_;                    // per column
  std::vector<std::uint64_t> occupied_;  // bit z % 64 of word z / 64 of each column
  std::vector<std::vector<Voxel>> voxels_;
};

}  // namespace rc2::cycle
