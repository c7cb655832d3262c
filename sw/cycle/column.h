// The voxel and illumination memories of all columns (rtl/rc2_column.sv).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sw/cycle/layers.h"
#include "sw/facet/packet.h"
#include "sw/machine/claim.h"

namespace rc2::cycle {

/// What a column keeps of a voxel's owner.
struct Owner {
  Claim claim;
  glm::ivec3 normal{0};  ///< rc2::normal_of
  facet::Surface surface = facet::Surface::solid;
};

/// Column c is that of cell y*n + x. Only occupied and guard voxels have an owner, so only they
/// take memory: they are listed in order of z, and a voxel's place is the number of such voxels
/// below it.
class Columns {
 public:
  explicit Columns(int n);

  /// Voxels of a column.
  int n() const { return n_; }

  /// n*n.
  std::size_t size() const { return voxels_.size(); }

  bool occupied(std::size_t column, int z) const { return has(occupied_, column, z); }
  bool is_guard(std::size_t column, int z) const {
    return has(owned_, column, z) && !occupied(column, z);
  }
  bool stops(std::size_t column, int z) const { return has(stops_, column, z); }

  /// The first such voxel from z on; n if there is none.
  int next_occupied(std::size_t column, int z) const { return next(occupied_, column, z, 0); }
  int next_owned(std::size_t column, int z) const { return next(owned_, column, z, 0); }
  int next_stop(std::size_t column, int z) const { return next(stops_, column, z, 0); }
  int next_passage(std::size_t column, int z) const {
    return next(stops_, column, z, ~std::uint64_t{0});
  }

  /// Forgets all voxels.
  void clear();

  /// Gives a voxel to the facet that claims it, unless its owner has the better claim.
  void fill(std::size_t column, int z, const Owner& owner);

  /// Likewise gives it a guard, unless it is occupied.
  void guard(std::size_t column, int z, const Owner& owner);

  /// The other layers; they take memory from the first time that any column is asked for them.
  ColumnLayers& layers(std::size_t column);
  const ColumnLayers& layers(std::size_t column) const;

  /// Forgets the light, and where it stops: in every occupied voxel.
  void darken();

  void set_stop(std::size_t column, int z, bool stops);

  /// Counts targets that arrive at an occupied voxel.
  void light(std::size_t column, int z, std::int64_t targets) {
    voxels_[column][place(column, z)].arrived += static_cast<std::uint32_t>(targets);
  }

  /// Of an occupied voxel or a guard.
  const Owner& owner(std::size_t column, int z) const {
    return voxels_[column][place(column, z)].owner;
  }
  std::uint32_t arrived(std::size_t column, int z) const {
    return voxels_[column][place(column, z)].arrived;
  }

 private:
  struct Voxel {
    Owner owner;
    std::uint32_t arrived;
  };
  using Bits = std::vector<std::uint64_t>;  // bit z % 64 of word z / 64 of each column

  std::size_t word_of(std::size_t column, int z) const {
    return column * words_ + static_cast<std::size_t>(z) / 64;
  }
  bool has(const Bits& bits, std::size_t column, int z) const {
    return (bits[word_of(column, z)] >> (z % 64) & 1U) != 0;
  }
  std::size_t place(std::size_t column, int z) const;
  int next(const Bits& bits, std::size_t column, int z, std::uint64_t flip) const;
  void claim(std::size_t column, int z, const Owner& owner, bool replaces);

  int n_;
  std::size_t words_;  // per column
  Bits occupied_, owned_, stops_;
  std::vector<std::vector<Voxel>> voxels_;
  std::vector<ColumnLayers> layers_;  // of each column, or none
};

}  // namespace rc2::cycle
