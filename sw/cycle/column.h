// The voxel and illumination memories of all columns (rtl/rc2_column.sv).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sw/cycle/layers.h"
#include "sw/machine/claim.h"

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

  /// The first occupied voxel, and the first free one, from z on; n if there is none.
  int next_occupied(std::size_t column, int z) const { return next(column, z, 0); }
  int next_free(std::size_t column, int z) const { return next(column, z, ~std::uint64_t{0}); }

  /// Forgets all voxels.
  void clear();

  /// Gives a voxel to the facet that claims it, unless its owner has the better claim.
  void fill(std::size_t column, int z, const Claim& claim, std::uint8_t facing);

  /// Which way the owner of an occupied voxel faces.
  std::uint8_t facing(std::size_t column, int z) const {
    return voxels_[column][place(column, z)].facing;
  }

  /// The other layers; they take memory from the first time that any column is asked for them.
  ColumnLayers& layers(std::size_t column);
  const ColumnLayers& layers(std::size_t column) const;

  /// Forgets the light.
  void darken();

  /// Counts targets that arrive at an occupied voxel.
  void absorb(std::size_t column, int z, std::int64_t targets) {
    voxels_[column][place(column, z)].arrived += static_cast<std::uint32_t>(targets);
  }

  Claim owner(std::size_t column, int z) const {
    return Claim::unpacked(voxels_[column][place(column, z)].claim);
  }
  std::uint32_t arrived(std::size_t column, int z) const {
    return voxels_[column][place(column, z)].arrived;
  }

 private:
  struct Voxel {
    std::uint32_t claim, arrived;
    std::uint8_t facing;
  };

  std::size_t word_of(std::size_t column, int z) const {
    return column * words_ + static_cast<std::size_t>(z) / 64;
  }
  std::size_t place(std::size_t column, int z) const;
  int next(std::size_t column, int z, std::uint64_t flip) const;

  int n_;
  std::size_t words_;                    // per column
  std::vector<std::uint64_t> occupied_;  // bit z % 64 of word z / 64 of each column
  std::vector<std::vector<Voxel>> voxels_;
  std::vector<ColumnLayers> layers_;  // of each column, or none
};

}  // namespace rc2::cycle
