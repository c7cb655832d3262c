#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "sw/facet/polygon.h"

namespace rc2::facet {

/// Low and high corner; the borders belong to it.
using Box = std::pair<Vertex, Vertex>;

/// Finds the boxes that meet a box. Keeps Boost.Geometry, which compiles slowly, in one place.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes);
  ~BoxTree();

  /// Calls visit with the index of each box that meets this one, in any order.
  void query(const Box& box, const std::function<void(std::uint32_t)>& visit) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace rc2::facet
