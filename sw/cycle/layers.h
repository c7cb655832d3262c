// What a column knows of its voxels beside their owners (rtl/rc2_column.sv): one bit each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rc2::cycle {

class VoxelBits {
 public:
  explicit VoxelBits(int n = 0) : bits_(static_cast<std::size_t>(n)) {}

  bool has(int z) const { return !bits_.empty() && bits_[static_cast<std::size_t>(z)]; }
  void set(int z) { bits_[static_cast<std::size_t>(z)] = true; }
  void flip(int z) { bits_[static_cast<std::size_t>(z)] = !has(z); }
  void clear(int z) { bits_[static_cast<std::size_t>(z)] = false; }
  int size() const { return static_cast<int>(bits_.size()); }

 private:
  std::vector<bool> bits_;
};

struct ColumnLayers {
  explicit ColumnLayers(int n = 0) : shown(n), inside(n), parity(n) {}

  VoxelBits shown, inside;
  VoxelBits parity;  ///< of the object under way

  void flip_from(int z) {
    for (; z < parity.size(); ++z) parity.flip(z);
  }

  void end_object() {
    for (int z = 0; z < parity.size(); ++z) {
      if (parity.has(z)) inside.set(z);
      parity.clear(z);
    }
  }
};

}  // namespace rc2::cycle
