#include "tb/load/golden_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "sw/golden/voxelise.h"
#include "tb/load/facet_case.h"

namespace rc2::facet {
namespace {

constexpr int kMargin = 3;    // voxels around a facet's vertices; the rules grow it by one at most
constexpr int kAnywhere = 8;  // columns anywhere in the cube

// A column within two voxels of one of the facet's sides.
glm::ivec2 near_side(const Border& border, const Cube& cube, Dice& dice) {
  const auto count = static_cast<std::int64_t>(border.size());
  const auto i = static_cast<std::size_t>(dice.roll(0, count - 1));
  const Vertex &from = border[i], &to = border[(i + 1) % border.size()];
  const Vertex at = from + (to - from) * dice.roll(0, 1 << 12) / std::int64_t{1 << 12};
  const glm::ivec2 jitter{dice.roll(-2, 2), dice.roll(-2, 2)};
  const glm::ivec2 column(at.x >> cube.fraction_bits, at.y >> cube.fraction_bits);
  return glm::clamp(column + jitter, glm::ivec2(0), glm::ivec2(cube.n - 1));
}

glm::ivec2 random_column(const glm::ivec3& low, const glm::ivec3& high, Dice& dice) {
  return {dice.roll(low.x, high.x), dice.roll(low.y, high.y)};
}

constexpr Span kNone{0, -1};
constexpr Column kEmpty{kNone, kNone};

std::string describe(const Column& column) {
  return fmt::format("z = {} .. {}, core {} .. {}", column.voxels.first, column.voxels.last,
                     column.core.first, column.core.last);
}

}  // namespace

scene::Scene scene_of(const std::vector<Border>& borders, const Cube& cube) {
  scene::Scene scene;
  scene.materials.resize(1);
  std::vector<glm::dvec3> corners;
  for (const Border& border : borders) {
    corners.clear();
    for (const Vertex& v : border)
      corners.push_back(glm::dvec3(v) / static_cast<double>(cube.one()));
    scene.add(corners, 0);
  }
  return scene;
}

Compared& Compared::operator+=(const Compared& other) {
  facets += other.facets;
  sampled += other.sampled;
  columns += other.columns;
  voxels += other.voxels;
  filled += other.filled;
  return *this;
}

void GoldenCheck::fill(const PacketStream& stream) {
  size_ = glm::ivec3(0);
  for (const PacketHead& head : stream.heads) {
    low_ = head.lo;
    size_ = head.hi - head.lo + 1;
    golden_.assign(static_cast<std::size_t>(size_.x) * size_.y, kEmpty);
    const facet::Side* sides = stream.sides.data() + head.first_side;
    golden::for_each_dexel(head, sides, [&](const golden::Dexel& dexel) {
      const auto span = [&](std::int64_t first, std::int64_t last) {
        return Span{low_.z + static_cast<int>(first), low_.z + static_cast<int>(last)};
      };
      golden_[static_cast<std::size_t>(dexel.y) * size_.x + dexel.x] = {
          span(dexel.z.first, dexel.z.last),
          span(std::max(dexel.z.first, dexel.core.first), std::min(dexel.z.last, dexel.core.last))};
    });
  }
}

Column GoldenCheck::golden_column(int x, int y) const {
  x -= low_.x;
  y -= low_.y;
  if (x < 0 || y < 0 || x >= size_.x || y >= size_.y) return kEmpty;
  return golden_[static_cast<std::size_t>(y) * size_.x + x];
}

template <typename Integer>
Compared GoldenCheck::compare(const Border& border, const Cube& cube, Rule rule,
                              std::int64_t columns, Dice& dice) const {
  const ColumnOracle<Integer> oracle(border, cube.one(), rule);
  Compared compared{1};
  const auto look = [&](const glm::ivec2& at) {
    const Column expected = oracle.column(at.x, at.y, cube.n);
    const Column found = golden_column(at.x, at.y);
    if (!(found == expected))
      throw Difference(fmt::format("column ({}, {}): the oracle says {}; the golden machine {}",
                                   at.x, at.y, describe(expected), describe(found)));
    ++compared.columns;
    compared.voxels += cube.n;
    compared.filled += std::max(0, expected.voxels.last - expected.voxels.first + 1);
  };
  const auto [low, high] = voxels_around(border, cube, kMargin);
  const glm::ivec3 size = high - low + 1;
  if (std::int64_t{size.x} * size.y <= columns) {
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) look({x, y});
  } else {
    compared.sampled = 1;
    for (std::int64_t i = 0; i < columns; ++i)
      look(i % 2 == 0 ? near_side(border, cube, dice) : random_column(low, high, dice));
  }
  for (int i = 0; i < kAnywhere; ++i)
    look(random_column(glm::ivec3(0), glm::ivec3(cube.n - 1), dice));
  return compared;
}

Compared GoldenCheck::check(const Border& border, const Cube& cube, Rule rule, std::int64_t columns,
                            Dice& dice) {
  const FacetSet set = build_facets(scene_of({border}, cube), cube.n, cube.fraction_bits, rule);
  if (set.counts.triangulated != 0) throw Difference("the host split a planar convex facet");
  if ((set.counts.degenerate == 0) != has_area(border))
    throw Difference("the host is wrong about its area");
  if (!has_area(border)) return {1};
  fill(set.packets);
  return rule == Rule::blindee ? compare<Int128>(border, cube, rule, columns, dice)
                               : compare<std::int64_t>(border, cube, rule, columns, dice);
}

}  // namespace rc2::facet
