#include "sw/facet/shells.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cstdlib>
#include <utility>

#include "sw/facet/copies.h"

namespace rc2::facet {
namespace {

// A polygon's side: from the lower to the higher vertex number, way 1, or back, way -1.
struct Use {
  std::uint64_t side;
  std::uint32_t polygon;
  int way;
};

// Corners at the same place have the same number, which is that of one of them.
std::vector<std::uint32_t> number_vertices(const std::vector<Vertex>& corners) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places;
  places.reserve(corners.size());
  for (const Vertex& corner : corners) {
    const glm::u64vec3 at(corner + (std::int64_t{1} << 19));
    places.emplace_back((at.x << 20 | at.y) << 20 | at.z,
                        static_cast<std::uint32_t>(places.size()));
  }
  std::sort(places.begin(), places.end());
  std::vector<std::uint32_t> numbers(corners.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_new = i == 0 || places[i].first != places[i - 1].first;
    numbers[places[i].second] = is_new ? places[i].second : numbers[places[i - 1].second];
  }
  return numbers;
}

class Joiner {
 public:
  explicit Joiner(const Traced& traced)
      : sets_(traced.polygon_count()), open_(traced.polygon_count()) {
    collect_sides(traced);
    for_each_side([&](const Use* first, const Use* last) {
      if (last - first == 2) sets_.union_set(first[0].polygon, first[1].polygon);
    });
    find_open();
    // What does not close by itself may close together with others round the same side.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours;
    for_each_side([&](const Use* first, const Use* last) {
      const Use* previous = nullptr;
      for (const Use* use = first; use != last; ++use) {
        if (!is_open(use->polygon)) continue;
        if (previous != nullptr) neighbours.emplace_back(previous->polygon, use->polygon);
        previous = use;
      }
    });
    for (const auto& [a, b] : neighbours) sets_.union_set(a, b);
    find_open();
  }

  /// Some polygon of the shell, the same for all of them.
  std::uint32_t shell(std::uint32_t polygon) { return sets_.find_set(polygon); }
  bool is_open(std::uint32_t polygon) { return open_[shell(polygon)]; }

  /// Calls visit(shell, side, balance) for every side that a shell uses more often in one direction
  /// than in the other.
  template <class Visit>
  void for_each_imbalance(const Visit& visit) {
    std::vector<std::pair<std::uint32_t, int>> ways;  // of a side: shell and way
    for_each_side([&](const Use* first, const Use* last) {
      ways.clear();
      for (const Use* use = first; use != last; ++use)
        ways.emplace_back(shell(use->polygon), use->way);
      std::sort(ways.begin(), ways.end());
      int balance = 0;
      for (std::size_t i = 0; i < ways.size(); ++i) {
        balance += ways[i].second;
        if (i + 1 < ways.size() && ways[i + 1].first == ways[i].first) continue;
        if (balance != 0) visit(ways[i].first, first->side, balance);
        balance = 0;
      }
    });
  }

 private:
  void collect_sides(const Traced& traced) {
    const std::vector<std::uint32_t> numbers = number_vertices(traced.corners);
    uses_.reserve(numbers.size());
    for (std::size_t polygon = 0; polygon < traced.polygon_count(); ++polygon) {
      const std::size_t first = traced.first[polygon], last = traced.first[polygon + 1];
      for (std::size_t i = first; i < last; ++i) {
        const std::uint64_t from = numbers[i], to = numbers[i + 1 == last ? first : i + 1];
        if (from == to) continue;
        uses_.push_back({std::min(from, to) << 32 | std::max(from, to),
                         static_cast<std::uint32_t>(polygon), from < to ? 1 : -1});
      }
    }
    std::sort(uses_.begin(), uses_.end(),
              [](const Use& a, const Use& b) { return a.side < b.side; });
  }

  void find_open() {
    std::fill(open_.begin(), open_.end(), false);
    for_each_imbalance([&](std::uint32_t shell, std::uint64_t, int) { open_[shell] = true; });
  }

  template <class Visit>
  void for_each_side(const Visit& visit) const {
    const Use* const end = uses_.data() + uses_.size();
    for (const Use *first = uses_.data(), *last; first != end; first = last) {
      last = std::find_if(first, end, [&](const Use& use) { return use.side != first->side; });
      visit(first, last);
    }
  }

  std::vector<Use> uses_;  // those of a side together
  boost::disjoint_sets_with_storage<boost::typed_identity_property_map<std::uint32_t>,
                                    boost::typed_identity_property_map<std::uint32_t>>
      sets_;
  std::vector<bool> open_;  // indexed by shell
};

}  // namespace

Shells find_shells(const Traced& traced) {
  Joiner joiner(traced);
  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> place(traced.polygon_count(), kNone);  // indexed by shell
  Shells shells;
  const auto place_in = [&](auto& kind, std::uint32_t shell) -> auto& {
    if (place[shell] == kNone) {
      place[shell] = static_cast<std::uint32_t>(kind.size());
      kind.emplace_back();
    }
    return kind[place[shell]];
  };
  for (std::size_t i = 0; i < traced.pieces.size(); ++i) {
    const std::uint32_t polygon = traced.pieces[i].polygon, shell = joiner.shell(polygon);
    Pieces& pieces = joiner.is_open(polygon) ? place_in(shells.open, shell).pieces
                                             : place_in(shells.closed, shell);
    pieces.push_back(static_cast<std::uint32_t>(i));
  }
  joiner.for_each_imbalance([&](std::uint32_t shell, std::uint64_t side, int balance) {
    if (place[shell] == kNone) return;  // no polygon of it has an area
    const Vertex &low = traced.corners[side >> 32], &high = traced.corners[side & 0xFFFFFFFF];
    const auto use = balance > 0 ? std::pair(low, high) : std::pair(high, low);
    std::vector<std::pair<Vertex, Vertex>>& rim = shells.open[place[shell]].rim;
    rim.insert(rim.end(), static_cast<std::size_t>(std::abs(balance)), use);
  });
  for (Pieces& shell : shells.closed) drop_copies(traced, shell);
  return shells;
}

}  // namespace rc2::facet
