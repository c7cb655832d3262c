#include "sw/cycle/load_array.h"

namespace rc2::cycle {
namespace {

constexpr std::int64_t kProgressCycles = 4096;

// The packets as words, one after the other.
class Host {
 public:
  explicit Host(const facet::PacketStream& packets) : packets_(packets) {}

  bool done() const { return head_ == packets_.heads.size(); }

  Word next() {
    const facet::PacketHead& head = packets_.heads[head_];
    if (word_ == 0) {
      ++word_;
      return head_word(head);
    }
    const facet::Bound& bound = packets_.bounds[head.first_bound + word_ - 1];
    const bool last = word_ == head.bound_count;
    if (last) {
      ++head_;
      word_ = 0;
    } else {
      ++word_;
    }
    return bound_word(bound, last);
  }

  double share() const {
    return static_cast<double>(head_) / static_cast<double>(packets_.heads.size());
  }

 private:
  const facet::PacketStream& packets_;
  std::size_t head_ = 0;
  std::uint32_t word_ = 0;  // of the packet; 0 is its HEAD
};

}  // namespace

LoadArray::LoadArray(int n, Columns& columns)
    : n_(static_cast<std::size_t>(n)), columns_(columns), units_(n_ * n_) {
  for (std::size_t stage = 0; stage < n_ * (n_ + 1); ++stage) {
    stages_.emplace_back(is_feeder(stage) ? Pipe::vertical : Pipe::row);
  }
  fires_.resize(stages_.size());
  listed_.resize(stages_.size());
}

std::int64_t LoadArray::run(const facet::PacketStream& packets, const Progress& progress) {
  Host host(packets);
  std::int64_t busy_cycles = 0;
  while (!host.done() || !active_.empty()) {
    if (!active_.empty()) ++busy_cycles;
    const bool taken = !host.done() && stages_[0].ready();
    for (const std::size_t stage : active_) decide(stage);
    next_active_.clear();
    for (const std::size_t stage : active_) step(stage);
    if (taken) push(0, host.next());
    active_.swap(next_active_);
    if (progress && busy_cycles % kProgressCycles == 0) progress("load", busy_cycles, host.share());
  }
  return busy_cycles;
}

// All decisions of a cycle come before all moves, and look at registers only.
void LoadArray::decide(std::size_t stage) {
  const FacetStage& own = stages_[stage];
  fires_[stage] = 0;
  if (!own.busy()) return;
  if (own.here()) {
    const bool unit_ready =
        is_feeder(stage) ? stages_[stage + 1].ready()
                         : units_[cell_of(stage)].dexel.ready(units_[cell_of(stage)].fill.ready());
    if (!unit_ready) return;
  }
  if (own.on() && !stages_[stage + (is_feeder(stage) ? n_ + 1 : 1)].ready()) return;
  fires_[stage] = 1;
}

void LoadArray::step(std::size_t stage) {
  FacetStage& own = stages_[stage];
  const bool fires = fires_[stage] != 0;
  const bool to_unit = fires && own.here();
  if (fires && own.on()) push(stage + (is_feeder(stage) ? n_ + 1 : 1), own.stepped());
  if (is_feeder(stage)) {
    if (to_unit) push(stage + 1, own.front());
  } else {
    Unit& unit = units_[cell_of(stage)];
    const bool fill_ready = unit.fill.ready();
    const Span offered = unit.dexel.offered();
    unit.fill.step(unit.dexel.offers() ? &offered : nullptr, columns_, cell_of(stage));
    unit.dexel.step(to_unit ? &own.front() : nullptr, fill_ready);
  }
  if (fires) own.pop();
  listed_[stage] = busy(stage) ? 1 : 0;
  if (busy(stage)) next_active_.push_back(stage);
}

void LoadArray::push(std::size_t stage, const Word& word) {
  stages_[stage].push(word);
  // A stage of this cycle's list whose turn is still to come lists itself.
  if (listed_[stage] == 0) {
    listed_[stage] = 1;
    next_active_.push_back(stage);
  }
}

bool LoadArray::busy(std::size_t stage) const {
  if (stages_[stage].busy()) return true;
  if (is_feeder(stage)) return false;
  const Unit& unit = units_[cell_of(stage)];
  return unit.dexel.busy() || unit.fill.busy();
}

}  // namespace rc2::cycle
