// The facets of a long run: case after case, each drawn from the run's seed and its own number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/load/facet_generator.h"

namespace rc2::facet {

struct FacetCase {
  FacetClass kind;
  Cube cube;
  std::vector<Border> borders;
};

/// Case `number` of the run: its class by turns, n and f at random. A facet over more than
/// `columns` columns is kept with probability columns / its own, else drawn again: the largest
/// would take all the time.
FacetCase draw_case(std::uint64_t seed, std::int64_t number, const std::vector<int>& sides,
                    std::int64_t columns);

/// Whether the border has an area; the others are dropped by the host.
bool has_area(const Border& border);

/// The voxels that the vertices reach, grown by `margin`, cut to the cube; axis by axis.
struct VoxelBox {
  glm::ivec3 low, high;
};
VoxelBox voxels_around(const Border& border, const Cube& cube, int margin);

/// For the one who looks for what went wrong.
std::string describe(const Border& border, const Cube& cube);

}  // namespace rc2::facet
