// The array while it loads (rtl/rc2_array.sv): the vertical pipes of row feeders, a pipe of cells
// in each row, and in each cell the dexel and fill units.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sw/cycle/cell_loader.h"
#include "sw/cycle/column.h"
#include "sw/cycle/facet_stage.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

/// What a stage of a pipe and the cell beside it are at in one cycle.
struct StageView {
  int x, y;   ///< of the cell; x is -1 in a vertical pipe
  int words;  ///< in its buffer, 0 to 2
  bool divides, writes;
};

/// Sees each busy cycle of a load: its number (the first is 1) and the stages that are busy in it,
/// in any order, as the registers hold them.
using LoadObserver = std::function<void(std::int64_t cycle, const std::vector<StageView>& stages)>;

class LoadArray {
 public:
  LoadArray(int n, int feeders, Columns& columns);

  /// Sends all packets, a word in every cycle in which a feeder takes one, and runs until
  /// everything is at rest. Returns the number of cycles in which anything was busy.
  std::int64_t run(const facet::PacketStream& packets, const LoadObserver& observer,
                   const Progress& progress);

  /// Likewise of given words, for each feeder its own.
  std::int64_t run(const std::vector<std::vector<Word>>& words, const Progress& progress);

  bool busy() const { return !active_.empty(); }

  /// Whether a feeder takes a word at the end of this cycle.
  bool ready(std::size_t feeder) const { return stages_[first_stage(feeder)].ready(); }

  /// One cycle. `words` has for each feeder the word that it takes, which must be ready, or none.
  void step(const std::vector<std::optional<Word>>& words);

 private:
  // Stage y*(n+1) is that of row y in its vertical pipe, the n after it are those of the row's
  // cells.
  std::size_t first_stage(std::size_t feeder) const { return feeder * (n_ + 1); }
  bool is_feeder(std::size_t stage) const { return stage % (n_ + 1) == 0; }
  std::size_t cell_of(std::size_t stage) const { return stage - stage / (n_ + 1) - 1; }
  std::size_t after(std::size_t stage) const {
    return stage + (is_feeder(stage) ? feeders_ * (n_ + 1) : 1);
  }

  bool is_last(std::size_t stage) const {
    return is_feeder(stage) ? after(stage) >= stages_.size() : is_feeder(stage + 1);
  }

  template <typename Source>
  std::int64_t run_from(std::vector<Source>& host, const LoadObserver& observer,
                        const Progress& progress);
  bool fires(std::size_t stage) const;
  void step_stage(std::size_t stage);
  void push(std::size_t stage, const Word& word);
  bool stage_busy(std::size_t stage) const;
  StageView view(std::size_t stage) const;
  void show(const LoadObserver& observer, std::int64_t cycle) const;

  std::size_t n_, feeders_;
  Columns& columns_;
  std::vector<FacetStage> stages_;
  std::vector<CellLoader> cells_;     // cell y*n + x
  std::vector<std::uint8_t> fires_;   // per stage: its oldest word leaves in this cycle
  std::vector<std::uint8_t> listed_;  // per stage: is in active_ or next_active_
  std::vector<std::size_t> active_, next_active_;
};

}  // namespace rc2::cycle
