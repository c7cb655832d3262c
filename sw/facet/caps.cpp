#include "sw/facet/caps.h"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>

#include "sw/facet/bounds.h"

namespace rc2::facet {
namespace {

using RimSide = std::pair<Vertex, Vertex>;

double area(const Border& border) {
  const Vertex doubled = doubled_area(border);
  const glm::dvec3 wide(doubled);
  return 0.5 * std::sqrt(wide.x * wide.x + wide.y * wide.y + wide.z * wide.z);
}

struct Before {
  bool operator()(const Vertex& a, const Vertex& b) const {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  }
};

// The sides of a rim, hole by hole: those that hang together by their corners.
std::vector<std::vector<RimSide>> split_into_holes(const std::vector<RimSide>& rim) {
  std::map<Vertex, std::uint32_t, Before> numbers;
  for (const auto& [from, to] : rim) numbers.try_emplace(from, numbers.size());
  for (const auto& [from, to] : rim) numbers.try_emplace(to, numbers.size());
  boost::disjoint_sets_with_storage<boost::typed_identity_property_map<std::uint32_t>,
                                    boost::typed_identity_property_map<std::uint32_t>>
      sets(numbers.size());
  for (const auto& [from, to] : rim) sets.union_set(numbers.at(from), numbers.at(to));
  std::map<std::uint32_t, std::vector<RimSide>> holes;
  for (const RimSide& side : rim) holes[sets.find_set(numbers.at(side.first))].push_back(side);
  std::vector<std::vector<RimSide>> result;
  result.reserve(holes.size());
  for (auto& [set, sides] : holes) result.push_back(std::move(sides));
  return result;
}

// The sides of the triangles round the middle cancel, because a hole's sides form closed paths.
std::vector<Border> caps_of(const std::vector<RimSide>& hole) {
  Vertex middle(0);
  for (const auto& [from, to] : hole) middle += from;
  middle /= static_cast<std::int64_t>(hole.size());
  std::vector<Border> caps;
  for (const auto& [from, to] : hole) {
    Border cap{to, from, middle};
    clean(cap);
    if (cap.size() == 3) caps.push_back(std::move(cap));
  }
  return caps;
}

}  // namespace

std::int64_t cap_holes(Traced& traced, Shells& shells) {
  constexpr double kLargestShare = 0.1;
  const auto is_capped = [&](OpenShell& shell) {
    double own_area = 0, caps_area = 0;
    for (const std::uint32_t i : shell.pieces) own_area += area(traced.pieces[i].border);
    std::vector<Border> caps;
    for (const std::vector<RimSide>& hole : split_into_holes(shell.rim)) {
      for (Border& cap : caps_of(hole)) {
        caps_area += area(cap);
        caps.push_back(std::move(cap));
      }
    }
    if (caps_area > kLargestShare * own_area) return false;
    for (Border& cap : caps) {
      const Vertex normal = plane_normal(cap);
      shell.pieces.push_back(static_cast<std::uint32_t>(traced.pieces.size()));
      traced.pieces.push_back({std::move(cap), normal, 0, {}});
    }
    shells.closed.push_back(std::move(shell.pieces));
    return true;
  };
  const auto last = std::remove_if(shells.open.begin(), shells.open.end(), is_capped);
  const std::int64_t count = shells.open.end() - last;
  shells.open.erase(last, shells.open.end());
  return count;
}

}  // namespace rc2::facet
