#include "sw/emission/ledger.h"

#include <algorithm>
#include <cstdlib>

namespace rc2::emission {

Ledger::Ledger(const golden::Grid& grid, std::size_t occupied)
    : grid_(grid),
      visits_(static_cast<std::size_t>(grid.n()) * static_cast<std::size_t>(grid.n())),
      touched_(grid.size()),
      lit_(occupied) {}

void Ledger::move(const glm::ivec3& from, const glm::ivec3& to) {
  ++cost_.visits;
  if (from.x != to.x || from.y != to.y) ++cost_.messages;
  std::int64_t& visits = visits_[static_cast<std::size_t>(to.y) * static_cast<std::size_t>(n()) +
                                 static_cast<std::size_t>(to.x)];
  cost_.busiest = std::max(cost_.busiest, ++visits);
  touched_[static_cast<std::size_t>(grid_.index(to))] = true;
}

void Ledger::answer(const glm::ivec3& from, const glm::ivec3& to) {
  ++cost_.rays;
  cost_.messages += std::max(std::abs(from.x - to.x), std::abs(from.y - to.y));
}

std::int64_t Ledger::untouched() const {
  std::int64_t count = 0;
  for (std::size_t place = 0; place < touched_.size(); ++place)
    count += grid_[static_cast<std::ptrdiff_t>(place)] == golden::Grid::kFree && !touched_[place];
  return count;
}

}  // namespace rc2::emission
