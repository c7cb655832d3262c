#include "sw/network/segments.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "sw/network/raster.h"
#include "sw/network/tree.h"

namespace rc2::network {
namespace {

/// The segments through a pixel: in a given column a steeper segment is never lower, so they are
/// consecutive.
struct Bundle {
  int first, last;
  bool within(Bundle other) const { return first >= other.first && last <= other.last; }
};

/// All segments of one N, and who passes where.
class Fan {
 public:
  explicit Fan(int n) : n_(n) {
    const std::size_t places = std::size_t(n + 1) * (n + 1);
    heights_.resize(places);
    bundles_.resize(places, {n, 0});
    for (int s = 0; s <= n; ++s) {
      for (const glm::ivec2 at : segment(n, s)) {
        heights_[at.x * (n + 1) + s] = at.y;
        Bundle& bundle = bundles_[at.x * (n + 1) + at.y];
        bundle = {std::min(bundle.first, s), s};
      }
    }
  }

  int height(int column, int s) const { return heights_[column * (n_ + 1) + s]; }
  Bundle through(int column, int y) const { return bundles_[column * (n_ + 1) + y]; }
  Bundle around(int column, int s) const { return through(column, height(column, s)); }

  /// Columns are numbered from the last one down, so that links go to later cells.
  int cell(int column, int y) const { return (n_ * (n_ + 3) - column * (column + 3)) / 2 + y; }

 private:
  int n_;
  std::vector<int> heights_;     // [column][segment]
  std::vector<Bundle> bundles_;  // [column][y]
};

/// Sorts and drops what is there twice; returns how many are left.
int unify(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return static_cast<int>(numbers.size());
}

/// Chooses the tails of all cells, column by column from the last one.
class Wiring {
 public:
  Wiring(int n, Scheme scheme)
      : n_(n), scheme_(scheme), fan_(n), parents_(tree_parents(n + 1, scheme.fan_out)) {
    network_.size = n;
    for (int y = 0; y <= n; ++y) network_.starts.push_back(fan_.cell(n, y));
    for (int column = n; column >= 0; --column) {
      for (int y = 0; y <= column; ++y) network_.cells.emplace_back(column, y);
    }
    depths_.assign(network_.cells.size(), 0);
    planned_depths_.assign(n + 1, 0);
    for (int column = n - 1; column >= 0; --column) {
      planned_depths_[column] = planned_depths_[planned_tail(column)] + 1;
    }
  }

  Network take() {
    for (int column = n_ - 1; column >= 0; --column) {
      for (int y = 0; y <= column; ++y) feed(column, y);
    }
    return std::move(network_);
  }

 private:
  int planned_tail(int column) const { return n_ - parents_[n_ - column]; }

  /// May the pixel of segment s in column x feed the one in `column`?
  bool right(int x, int column, int s) const {
    return x > column && x <= n_ && fan_.around(x, s).within(fan_.around(column, s)) &&
           (!scheme_.keep_depth ||
            depths_[fan_.cell(x, fan_.height(x, s))] < planned_depths_[column]);
  }

  int nearest_right_column(int column, int s) const {
    const int planned = planned_tail(column);
    int away = 0;  // the end point is always right, so the search ends
    while (!right(planned + away, column, s) && !right(planned - away, column, s)) ++away;
    return right(planned + away, column, s) ? planned + away : planned - away;
  }

  void feed(int column, int y) {
    const int planned = planned_tail(column);
    const int head = fan_.cell(column, y);
    const Bundle bundle = fan_.through(column, y);
    Repair& repair = network_.repair;
    std::vector<int> plan;
    std::vector<int> wrong;
    std::vector<int> tails;
    for (int s = bundle.first; s <= bundle.last; ++s) {
      const int x = nearest_right_column(column, s);
      const int meant = fan_.cell(planned, fan_.height(planned, s));
      plan.push_back(meant);
      if (x != planned) wrong.push_back(meant);
      repair.threshold = std::max(repair.threshold, std::abs(x - planned));
      tails.push_back(fan_.cell(x, fan_.height(x, s)));
    }
    repair.planned += unify(plan);
    repair.wrong += unify(wrong);
    unify(tails);
    for (const int tail : tails) {
      network_.links.push_back({tail, head});
      depths_[head] = std::max(depths_[head], depths_[tail] + 1);
    }
  }

  int n_;
  Scheme scheme_;
  Fan fan_;
  std::vector<int> parents_;         // of the places along a segment, the end point's being 0
  std::vector<int> planned_depths_;  // [column]
  std::vector<int> depths_;          // [cell]
  Network network_;
};

}  // namespace

Network build_segments(int n, Scheme scheme) { return Wiring(n, scheme).take(); }

}  // namespace rc2::network
