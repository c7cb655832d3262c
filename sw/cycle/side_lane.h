// The side lanes of all cells: beams towards the x and y faces (rtl/lanes/rc2_side_lane.sv).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "sw/cycle/classes.h"
#include "sw/cycle/column.h"
#include "sw/cycle/extents.h"
#include "sw/cycle/stop_table.h"
#include "sw/cycle/tally.h"
#include "sw/machine/machine.h"

namespace rc2::cycle {

/// A beam of a whole column: V targets of one interval, U targets of some classes of the cell. It
/// is at as many voxels as its V targets are.
struct ColumnBeam {
  Targets v;
  ClassSet u;
  bool along_y;
};

/// What a cell holds of side beams: one FIFO for the neighbour towards the light in the same row or
/// column (`straight`), one for the diagonal neighbour, and the beam that is served.
class SideLane {
 public:
  SideLane(int n, Columns& columns);

  /// `outlooks` says of each cell what its beams can still meet; what counts is what it knows when
  /// it hears of its step.
  void start(const LightJob& light, const Classes& classes, const std::vector<Outlook>& outlooks);

  bool busy() const { return !active_.empty(); }

  /// One cycle of all cells; false if nothing moved.
  bool step(std::int64_t cycle);

  /// Calls visit(from, to), numbers of cells, for each beam that was sent in the last cycle.
  template <typename Visit>
  void for_each_sent(Visit visit) const {
    for (const Arrival& arrival : arrivals_) visit(arrival.sender, arrival.cell);
  }

  /// Beams in each cell.
  const std::vector<std::uint32_t>& queues() const { return held_; }

  /// The last cycle in which a cell held a beam, or marked what one had lit.
  std::int64_t last_busy() const { return last_busy_; }

  const Tally& tally() const { return tally_; }
  std::int64_t absorbed() const { return absorbed_; }
  std::int64_t escaped() const { return escaped_; }
  std::int64_t skipped() const { return skipped_; }
  std::int64_t visits() const { return visits_; }
  std::int64_t merged() const { return merged_; }
  std::int64_t max_queue() const { return max_queue_; }
  const std::vector<std::size_t>& active() const { return active_; }

 private:
  enum From : unsigned { kStraight, kDiagonal };
  struct Cell {
    std::uint16_t x, y;
    Extent beyond;  // layers in which it is worth while
    bool table_made;
    bool serving;
    std::array<std::uint16_t, 2> first, count;
    ColumnBeam beam;  // being served
    StopTable table;
  };
  struct Arrival {
    std::size_t sender, cell;
    From from;
    ColumnBeam beam;
  };

  int steps(const Cell& cell) const;
  // The first cycle in which the cell knows the classes of the beams that come by.
  std::int64_t here(const Cell& cell) const { return 2 * steps(cell) + 2; }
  Slope slope(const Cell& cell) const { return {steps(cell), light_.target_distance}; }
  // The cycle in which the cell hears of its step.
  std::int64_t told(const Cell& cell) const { return std::max(2 * steps(cell) - 3, 0); }
  std::int64_t weight(const Cell& cell, const ColumnBeam& beam) const;
  ColumnBeam& place(std::size_t cell, From from, std::size_t index) {
    return fifo_[(cell * 2 + from) * depth_ + index];
  }
  void reach(std::size_t cell);
  bool serve(std::size_t number, std::int64_t cycle);
  bool serve_source(Cell& cell, std::int64_t cycle);
  bool serve_column(std::size_t number, std::int64_t cycle);
  bool send(const Cell& cell, const ColumnBeam& beam, const Targets& free, std::int64_t cycle);
  void light(std::size_t number, const Targets& targets);
  bool load(std::size_t number, std::int64_t cycle);
  ColumnBeam take(std::size_t number);
  void finish(const Cell& cell, std::int64_t targets, std::int64_t& where, std::int64_t cycle);

  int n_;
  Columns& columns_;
  LightJob light_{};
  const Classes* classes_ = nullptr;
  std::size_t depth_ = 0;
  std::vector<Cell> cells_;
  std::vector<ColumnBeam> fifo_;
  std::vector<std::uint32_t> held_;
  std::vector<std::uint8_t> listed_;
  std::vector<std::size_t> active_;
  std::vector<Arrival> arrivals_;
  std::vector<std::pair<std::size_t, From>> taken_;

  Tally tally_;
  std::int64_t absorbed_ = 0, escaped_ = 0, skipped_ = 0, visits_ = 0, merged_ = 0;
  std::int64_t max_queue_ = 0, last_busy_ = 0;
};

}  // namespace rc2::cycle
