// One facet at a time: the golden machine's voxels against the oracle's.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sw/facet/facet.h"
#include "tb/load/column_oracle.h"
#include "tb/load/dice.h"
#include "tb/load/facet_generator.h"

namespace rc2::facet {

/// Two answers differ; the message says where.
class Difference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What was compared, of one facet or of many.
struct Compared {
  std::int64_t facets = 0;
  std::int64_t sampled = 0;  ///< facets of which not every column was looked at
  std::int64_t columns = 0, voxels = 0, filled = 0;

  Compared& operator+=(const Compared& other);
};

class GoldenCheck {
 public:
  /// Every column around the facet, if there are at most `columns`; else so many, half of them near
  /// its sides; and always some anywhere in the cube. Each voxel of a column is compared, and
  /// whether it is of the core. Throws Difference. A facet without area must be dropped.
  Compared check(const Border& border, const Cube& cube, Rule rule, std::int64_t columns,
                 Dice& dice);

 private:
  void fill(const PacketStream& stream);
  Column golden_column(int x, int y) const;
  template <typename Integer>
  Compared compare(const Border& border, const Cube& cube, Rule rule, std::int64_t columns,
                   Dice& dice) const;

  // The golden machine's columns over low .. low + size - 1.
  glm::ivec3 low_{0}, size_{0};
  std::vector<Column> golden_;
};

/// A scene of these borders, in voxels.
scene::Scene scene_of(const std::vector<Border>& borders, const Cube& cube);

}  // namespace rc2::facet
