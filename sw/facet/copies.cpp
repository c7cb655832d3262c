#include "sw/facet/copies.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rc2::facet {
namespace {

bool is_before(const Vertex& a, const Vertex& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

// The same for borders that begin elsewhere.
Border rotated(Border border) {
  std::rotate(border.begin(), std::min_element(border.begin(), border.end(), is_before),
              border.end());
  return border;
}

bool is_border_before(const Border& a, const Border& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_before);
}

}  // namespace

void drop_copies(const Traced& traced, Pieces& shell) {
  std::vector<std::pair<Border, std::uint32_t>> borders;
  borders.reserve(shell.size());
  for (const std::uint32_t piece : shell)
    borders.emplace_back(rotated(traced.pieces[piece].border), piece);
  std::stable_sort(borders.begin(), borders.end(),
                   [](const auto& a, const auto& b) { return is_border_before(a.first, b.first); });
  Pieces kept;
  std::size_t copies = 0;
  for (std::size_t first = 0, last = 0; first < borders.size(); first = last) {
    while (last < borders.size() && borders[last].first == borders[first].first) ++last;
    if (first == 0) copies = last;
    if (last - first != copies) return;
    kept.push_back(borders[first].second);
  }
  if (copies == 1) return;
  std::sort(kept.begin(), kept.end());
  shell = kept;
}

}  // namespace rc2::facet
