#include "sw/cycle/load_array.h"

#include <algorithm>

#include "sw/machine/feeder.h"

namespace rc2::cycle {
namespace {

constexpr std::int64_t kProgressCycles = 4096;

// Words one after another, as FeederWords gives those of packets.
class GivenWords {
 public:
  explicit GivenWords(const std::vector<Word>& words) : words_(words) {}
  bool done() const { return at_ == words_.size(); }
  const Word& next() { return words_[at_++]; }
  double share() const {
    return static_cast<double>(at_) / static_cast<double>(std::max<std::size_t>(1, words_.size()));
  }

 private:
  const std::vector<Word>& words_;
  std::size_t at_ = 0;
};

}  // namespace

LoadArray::LoadArray(int n, int feeders, Columns& columns)
    : n_(static_cast<std::size_t>(n)),
      feeders_(static_cast<std::size_t>(feeders)),
      columns_(columns),
      cells_(n_ * n_, CellLoader(n)) {
  for (std::size_t stage = 0; stage < n_ * (n_ + 1); ++stage) {
    if (is_feeder(stage)) {
      stages_.emplace_back(Pipe::vertical, feeders);
    } else {
      stages_.emplace_back(Pipe::row, 1);
    }
  }
  fires_.resize(stages_.size());
  listed_.resize(stages_.size());
}

std::int64_t LoadArray::run(const facet::PacketStream& packets, const LoadObserver& observer,
                            const Progress& progress) {
  std::vector<FeederWords> host;
  for (std::size_t k = 0; k < feeders_; ++k) {
    host.emplace_back(packets, static_cast<int>(k), static_cast<int>(feeders_));
  }
  return run_from(host, observer, progress);
}

std::int64_t LoadArray::run(const std::vector<std::vector<Word>>& words, const Progress& progress) {
  std::vector<GivenWords> host(words.begin(), words.end());
  return run_from(host, {}, progress);
}

template <typename Source>
std::int64_t LoadArray::run_from(std::vector<Source>& host, const LoadObserver& observer,
                                 const Progress& progress) {
  const auto unsent = [&] {
    return std::any_of(host.begin(), host.end(), [](const Source& f) { return !f.done(); });
  };
  std::vector<std::optional<Word>> words(feeders_);
  std::int64_t busy_cycles = 0;
  while (busy() || unsent()) {
    if (busy()) {
      ++busy_cycles;
      if (observer) show(observer, busy_cycles);
    }
    for (std::size_t k = 0; k < feeders_; ++k) {
      words[k].reset();
      if (!host[k].done() && ready(k)) words[k] = host[k].next();
    }
    step(words);
    if (progress && busy_cycles % kProgressCycles == 0) {
      progress("load", busy_cycles, host[0].share());
    }
  }
  return busy_cycles;
}

void LoadArray::step(const std::vector<std::optional<Word>>& words) {
  // All decisions come before all moves, and look at registers only.
  for (const std::size_t stage : active_) fires_[stage] = fires(stage) ? 1 : 0;
  next_active_.clear();
  for (const std::size_t stage : active_) step_stage(stage);
  for (std::size_t k = 0; k < feeders_; ++k) {
    if (words[k]) push(first_stage(k), *words[k]);
  }
  active_.swap(next_active_);
}

bool LoadArray::fires(std::size_t stage) const {
  const FacetStage& own = stages_[stage];
  if (!own.busy()) return false;
  if (own.on() && !is_last(stage) && !stages_[after(stage)].ready()) return false;
  if (!own.here()) return true;
  if (is_feeder(stage)) return stages_[stage + 1].ready();
  return cells_[cell_of(stage)].ready(own.front());
}

void LoadArray::step_stage(std::size_t stage) {
  FacetStage& own = stages_[stage];
  const bool fires = fires_[stage] != 0;
  const bool here = own.busy() && own.here();
  // What goes beyond the last unit of a pipe has told everybody.
  if (fires && own.on() && !is_last(stage)) push(after(stage), own.stepped());
  if (!is_feeder(stage)) {
    const std::size_t column = cell_of(stage);
    cells_[column].step(here ? &own.front() : nullptr, fires, columns_, column);
  } else if (fires && here) {
    push(stage + 1, own.front());
  }
  if (fires) own.pop();
  listed_[stage] = stage_busy(stage) ? 1 : 0;
  if (stage_busy(stage)) next_active_.push_back(stage);
}

void LoadArray::push(std::size_t stage, const Word& word) {
  stages_[stage].push(word);
  // A stage of this cycle's list whose turn is still to come lists itself.
  if (listed_[stage] == 0) {
    listed_[stage] = 1;
    next_active_.push_back(stage);
  }
}

bool LoadArray::stage_busy(std::size_t stage) const {
  return stages_[stage].busy() || (!is_feeder(stage) && cells_[cell_of(stage)].busy());
}

StageView LoadArray::view(std::size_t stage) const {
  const auto y = static_cast<int>(stage / (n_ + 1)), x = static_cast<int>(stage % (n_ + 1)) - 1;
  const int words = stages_[stage].held();
  if (is_feeder(stage)) return {x, y, words, false, false};
  const CellLoader& cell = cells_[cell_of(stage)];
  return {x, y, words, cell.dividing(), cell.writing()};
}

void LoadArray::show(const LoadObserver& observer, std::int64_t cycle) const {
  std::vector<StageView> stages;
  for (const std::size_t stage : active_) stages.push_back(view(stage));
  observer(cycle, stages);
}

}  // namespace rc2::cycle
