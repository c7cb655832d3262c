#include "sw/cycle/column.h"

#include <algorithm>
#include <bitset>

namespace rc2::cycle {
namespace {

std::uint64_t bit_of(int z) { return std::uint64_t{1} << (z % 64); }

std::size_t count_bits(std::uint64_t word) { return std::bitset<64>(word).count(); }

}  // namespace

Columns::Columns(int n)
    : n_(n),
      words_(static_cast<std::size_t>(n + 63) / 64),
      occupied_(words_ * static_cast<std::size_t>(n) * static_cast<std::size_t>(n)),
      owned_(occupied_.size()),
      stops_(occupied_.size()),
      voxels_(static_cast<std::size_t>(n) * static_cast<std::size_t>(n)) {}

void Columns::clear() {
  std::fill(occupied_.begin(), occupied_.end(), 0);
  std::fill(owned_.begin(), owned_.end(), 0);
  for (auto& column : voxels_) column.clear();
  layers_.clear();
}

void Columns::fill(std::size_t column, int z, const Owner& owner) {
  claim(column, z, owner, !occupied(column, z));
  occupied_[word_of(column, z)] |= bit_of(z);
}

void Columns::guard(std::size_t column, int z, const Owner& owner) {
  if (!occupied(column, z)) claim(column, z, owner, false);
}

void Columns::claim(std::size_t column, int z, const Owner& owner, bool replaces) {
  auto& voxels = voxels_[column];
  const std::size_t at = place(column, z);
  if (!has(owned_, column, z)) {
    owned_[word_of(column, z)] |= bit_of(z);
    voxels.insert(voxels.begin() + static_cast<std::ptrdiff_t>(at), {owner, 0});
  } else if (replaces || owner.claim.packed() < voxels[at].owner.claim.packed()) {
    voxels[at] = {owner, 0};
  }
}

void Columns::set_stop(std::size_t column, int z, bool stops) {
  std::uint64_t& word = stops_[word_of(column, z)];
  word = stops ? word | bit_of(z) : word & ~bit_of(z);
}

ColumnLayers& Columns::layers(std::size_t column) {
  if (layers_.empty()) layers_.assign(size(), ColumnLayers(n_));
  return layers_[column];
}

const ColumnLayers& Columns::layers(std::size_t column) const {
  static const ColumnLayers none;
  return layers_.empty() ? none : layers_[column];
}

void Columns::darken() {
  for (auto& column : voxels_) {
    for (Voxel& voxel : column) voxel.arrived = 0;
  }
  stops_ = occupied_;
}

int Columns::next(const Bits& bits, std::size_t column, int z, std::uint64_t flip) const {
  while (z < n_) {
    const std::uint64_t rest = (bits[word_of(column, z)] ^ flip) >> (z % 64);
    if (rest != 0) return std::min(n_, z + __builtin_ctzll(rest));
    z += 64 - z % 64;
  }
  return n_;
}

std::size_t Columns::place(std::size_t column, int z) const {
  const std::size_t word = word_of(column, z);
  std::size_t below = count_bits(owned_[word] & (bit_of(z) - 1));
  for (std::size_t i = column * words_; i < word; ++i) below += count_bits(owned_[i]);
  return below;
}

}  // namespace rc2::cycle
