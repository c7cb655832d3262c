#include "sw/surface/slices.h"

#include <algorithm>
#include <vector>

#include "sw/surface/outline.h"

namespace rc2::surface {
namespace {

// A corner of a slice; y is the slice's.
struct Corner {
  std::int64_t x, z;
};
using Slice = std::vector<Corner>;

// One of the two chains of a slice's sides from its least x to its greatest (the thesis's m1, m2).
class Chain {
 public:
  Chain(const Slice& slice, std::size_t leftmost, int turn)
      : slice_(slice), turn_(static_cast<std::size_t>(turn)), from_(leftmost), to_(next(leftmost)) {
    pass(slice[leftmost].x);
  }

  // z of the chain in a column, asked for from left to right, not beyond the greatest x.
  Fraction at(std::int64_t x, std::int64_t greatest) {
    if (x < greatest) pass(x);
    const Corner &left = slice_[from_], &right = slice_[to_];
    const std::int64_t width = right.x - left.x;
    return {left.z * width + (right.z - left.z) * (x - left.x), width};
  }

 private:
  // Goes on to the side that leaves column x.
  void pass(std::int64_t x) {
    while (slice_[to_].x == x) {
      from_ = to_;
      to_ = next(to_);
    }
  }

  std::size_t next(std::size_t corner) const {
    return (corner + slice_.size() + turn_) % slice_.size();
  }

  const Slice& slice_;
  std::size_t turn_, from_, to_;
};

void fill_column(std::int64_t x, std::int64_t y, const Fraction& one, const Fraction& other,
                 VoxelSet& voxels) {
  const auto [low, high] = std::minmax({nearest(one), nearest(other)});
  for (std::int64_t z = low; z <= high; ++z) voxels[glm::ivec3(x, y, z)] = 1;
}

void fill(const Slice& slice, std::int64_t y, VoxelSet& voxels) {
  const auto by_x = [](const Corner& a, const Corner& b) { return a.x < b.x; };
  const auto [leftmost, rightmost] = std::minmax_element(slice.begin(), slice.end(), by_x);
  if (leftmost->x == rightmost->x) {
    const auto [low, high] = std::minmax_element(
        slice.begin(), slice.end(), [](const Corner& a, const Corner& b) { return a.z < b.z; });
    fill_column(leftmost->x, y, {low->z, 1}, {high->z, 1}, voxels);
    return;
  }
  const auto start = static_cast<std::size_t>(leftmost - slice.begin());
  Chain one(slice, start, +1), other(slice, start, -1);
  for (std::int64_t x = leftmost->x; x <= rightmost->x; ++x)
    fill_column(x, y, one.at(x, rightmost->x), other.at(x, rightmost->x), voxels);
}

}  // namespace

void fill_slices(const facet::Border& border, VoxelSet& voxels) {
  const auto [lowest, highest] = std::minmax_element(
      border.begin(), border.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  if (lowest->y == highest->y) {
    Slice slice;
    for (const facet::Vertex& at : border) slice.push_back({at.x, at.z});
    fill(slice, lowest->y, voxels);
    return;
  }
  Outline one(border, +1), other(border, -1);
  const auto corner = [](const Crossing& at) { return Corner{nearest(at.x), nearest(at.z)}; };
  Corner upper_one = corner(one.at(highest->y)), upper_other = corner(other.at(highest->y));
  for (std::int64_t y = highest->y; y >= lowest->y; --y) {
    const Corner lower_one = corner(one.at(y)), lower_other = corner(other.at(y));
    fill({lower_one, lower_other, upper_other, upper_one}, y, voxels);
    upper_one = lower_one;
    upper_other = lower_other;
  }
}

}  // namespace rc2::surface
