// Boost 1.74's own headers would else remark on each other.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include "sw/facet/box_tree.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

namespace rc2::facet {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<std::int64_t, 3, bg::cs::cartesian>;
using Area = bg::model::box<Point>;
using Entry = std::pair<Area, std::uint32_t>;

Area area_of(const Box& box) {
  const auto& [low, high] = box;
  return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
}

std::vector<Entry> entries_of(const std::vector<Box>& boxes) {
  std::vector<Entry> entries;
  entries.reserve(boxes.size());
  for (const Box& box : boxes)
    entries.emplace_back(area_of(box), static_cast<std::uint32_t>(entries.size()));
  return entries;
}

}  // namespace

struct BoxTree::Tree : bg::index::rtree<Entry, bg::index::quadratic<16>> {
  using rtree::rtree;
};

BoxTree::BoxTree(const std::vector<Box>& boxes)
    : tree_(std::make_unique<const Tree>(entries_of(boxes))) {}

BoxTree::~BoxTree() = default;

void BoxTree::query(const Box& box, const std::function<void(std::uint32_t)>& visit) const {
  tree_->query(
      bg::index::intersects(area_of(box)),
      boost::make_function_output_iterator([&](const Entry& entry) { visit(entry.second); }));
}

}  // namespace rc2::facet
