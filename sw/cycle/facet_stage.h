// One stage of a pipe that walks packets past a line of units (rtl/load/rc2_facet_stage.sv).
#pragma once

#include <array>

#include "sw/machine/word.h"

namespace rc2::cycle {

/// The vertical pipe feeds rows, a row pipe feeds cells: they differ in the lead they read.
enum class Pipe : std::uint8_t { row = 0, vertical = 1 };

class FacetStage {
 public:
  /// `stride`: units from this one to the next.
  FacetStage(Pipe pipe, std::int64_t stride)
      : lead_(static_cast<std::size_t>(pipe)), stride_(stride) {}

  bool ready() const { return held_ != 2; }
  bool busy() const { return held_ != 0; }
  int held() const { return static_cast<int>(held_); }

  /// The oldest word; only if busy().
  const Word& front() const { return buffer_[first_]; }

  /// Whether the oldest word is for the unit beside, and whether for the next stage.
  bool here() const;
  bool on() const;

  /// The oldest word as the next stage gets it.
  Word stepped() const;

  /// The oldest word leaves, to wherever here() and on() said.
  void pop();

  /// A word enters. A word that entered in this cycle is not yet at the front of a busy stage, so
  /// pop() and push() of one cycle may come in either order.
  void push(const Word& word);

 private:
  std::size_t lead_;
  std::int64_t stride_;
  std::array<Word, 2> buffer_{};
  std::size_t first_ = 0, held_ = 0;
  bool here_ = false, on_ = false;  // the packet under way: serves this unit, goes on
};

}  // namespace rc2::cycle
