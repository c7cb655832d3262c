#include "sw/emission/path_table.h"

#include <algorithm>
#include <map>
#include <set>

#include "sw/lines/digital_line.h"

namespace rc2::emission {
namespace {

Path path_to(int target, int distance) {
  lines::DigitalLine line(target, distance);
  Path path;
  for (int step = 0; step < distance; ++step) path += letter_of(line.advance());
  return path;
}

// Which steps follow each way that a beam can have come.
std::map<Path, std::set<char>> next_steps(const PathTable& table) {
  std::map<Path, std::set<char>> next;
  for (const Path& path : table.paths())
    for (std::size_t length = 0; length < path.size(); ++length)
      next[path.substr(0, length)].insert(path[length]);
  return next;
}

bool is_enough(const std::map<Path, std::set<char>>& next, std::size_t last_steps) {
  std::map<Path, const std::set<char>*> seen;
  for (const auto& [path, steps] : next) {
    const std::size_t kept = std::min(path.size(), last_steps);
    const auto [known, is_new] = seen.emplace(path.substr(path.size() - kept), &steps);
    if (!is_new && *known->second != steps) return false;
  }
  return true;
}

}  // namespace

PathTable::PathTable(int first, int last, int distance) {
  for (int target = first; target <= last; ++target) paths_.push_back(path_to(target, distance));
}

bool PathTable::has(const Path& beginning, std::int64_t& looks) const {
  const auto begins = [&](const Path& path) {
    return path.compare(0, beginning.size(), beginning);
  };
  const auto found = std::partition_point(paths_.begin(), paths_.end(), [&](const Path& path) {
    ++looks;
    return begins(path) < 0;
  });
  return found != paths_.end() && begins(*found) == 0;
}

TableFacts octant_facts(int n) {
  const auto next = next_steps(PathTable(0, n - 1, n - 1));
  // Keeping more steps never confuses ways that fewer tell apart.
  int low = 0, high = n - 1;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (is_enough(next, static_cast<std::size_t>(middle)))
      high = middle;
    else
      low = middle + 1;
  }
  return {static_cast<std::int64_t>(next.size()), low};
}

}  // namespace rc2::emission
