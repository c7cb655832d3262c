#include "tb/load/facet_case.h"

#include <fmt/format.h>

#include <glm/common.hpp>

#include "sw/base/config.h"
#include "tb/load/dice.h"

namespace rc2::facet {
namespace {

int floor_voxel(std::int64_t length, const Cube& cube) {
  return static_cast<int>(length >> cube.fraction_bits);
}

std::int64_t most_columns(const FacetCase& drawn) {
  std::int64_t most = 0;
  for (const Border& border : drawn.borders) {
    const VoxelBox box = voxels_around(border, drawn.cube, 1);
    const glm::ivec3 size = box.high - box.low + 1;
    most = std::max(most, std::int64_t{size.x} * size.y);
  }
  return most;
}

}  // namespace

FacetCase draw_case(std::uint64_t seed, std::int64_t number, const std::vector<int>& sides,
                    std::int64_t columns) {
  const auto place = static_cast<std::uint64_t>(number);
  Dice dice(Dice(seed).bits() ^ Dice(place).bits());
  FacetCase drawn;
  drawn.kind = kFacetClasses[place % kFacetClasses.size()];
  do {
    const auto side = dice.roll(0, static_cast<std::int64_t>(sides.size()) - 1);
    const auto fraction_bits = dice.roll(0, kMaxFractionBits);
    drawn.cube = {sides[static_cast<std::size_t>(side)], static_cast<int>(fraction_bits)};
    drawn.borders = generate_facets(drawn.kind, drawn.cube, dice.bits());
  } while (dice.roll(1, std::max(columns, most_columns(drawn))) > columns);
  return drawn;
}

bool has_area(const Border& border) { return doubled_area(border) != Vertex(0); }

VoxelBox voxels_around(const Border& border, const Cube& cube, int margin) {
  Vertex low = border[0], high = border[0];
  for (const Vertex& v : border) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  VoxelBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::max(0, floor_voxel(low[axis], cube) - margin);
    box.high[axis] = std::min(cube.n - 1, floor_voxel(high[axis] - 1, cube) + 1 + margin);
  }
  return box;
}

std::string describe(const Border& border, const Cube& cube) {
  std::string text =
      fmt::format("n = {}, f = {}, vertices in 2^-f voxel:", cube.n, cube.fraction_bits);
  for (const Vertex& v : border) text += fmt::format(" ({}, {}, {})", v.x, v.y, v.z);
  return text;
}

}  // namespace rc2::facet
