// The thesis's other splitter: the ways of all rays of a plane, written down (4.3.2).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rc2::emission {

/// The steps of a ray sideways, one for each step along its axis: '0' + step, which is '/', '0' or
/// '1', so that ways of one octant look as the thesis prints them.
using Path = std::string;

constexpr char letter_of(int step) { return static_cast<char>('0' + step); }

class PathTable {
 public:
  /// The digital rays to the targets first .. last of a face at `distance`, of so many steps each.
  PathTable(int first, int last, int distance);

  /// In ascending order, which is that of the targets.
  const std::vector<Path>& paths() const { return paths_; }

  /// Whether a ray begins so, found by halving the table. `looks` grows by the entries compared.
  bool has(const Path& beginning, std::int64_t& looks) const;

 private:
  std::vector<Path> paths_;
};

/// Facts of the table of one octant, N rays to targets 0 .. N-1 at distance N-1, of N-1 steps.
struct TableFacts {
  std::int64_t prefixes;  ///< ways that a beam can have come, the empty one included
  int last_steps;         ///< so many of the last steps tell all ways apart that part differently
};

TableFacts octant_facts(int n);

}  // namespace rc2::emission
