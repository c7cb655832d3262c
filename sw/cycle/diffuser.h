// The beam engine of every cell in thesis mode (rtl/light/rc2_diffuser.sv): its queue, and the beam
// at the head of it that is absorbed, split or waiting.
#pragma once

#include <cstdint>
#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "sw/cycle/column.h"
#include "sw/cycle/router.h"
#include "sw/cycle/tally.h"

namespace rc2::cycle {

class Diffuser {
 public:
  Diffuser(int n, Columns& columns, Router& router);

  /// Empties all queues. Throws Error if there is no memory for queues of this depth.
  void start(const LightJob& light);

  bool busy(std::size_t cell) const { return count_[cell] != 0; }

  /// One cycle of a cell, after the links have moved. Returns whether anything changed.
  bool step(std::size_t cell, std::int64_t cycle);

  /// Beams in each queue, and the beam at the head of one that is not empty.
  const std::vector<std::uint32_t>& queues() const { return count_; }
  const Beam& head(std::size_t cell) const { return ring_[cell * depth_ + first_[cell]]; }

  const Tally& tally() const { return tally_; }
  std::int64_t absorbed() const { return absorbed_; }
  std::int64_t escaped() const { return escaped_; }
  std::int64_t visits() const { return visits_; }        ///< beams that left a queue
  std::int64_t max_queue() const { return max_queue_; }  ///< deepest queue

 private:
  struct Served {
    bool something, own_child;
  };
  Served serve(std::size_t cell, std::int64_t cycle);
  void absorb(std::size_t cell, std::int64_t cycle);
  void push(std::size_t cell, const Beam& beam);
  void pop(std::size_t cell);

  int n_;
  std::vector<glm::u16vec2> at_;  // where each cell is
  Columns& columns_;
  Router& router_;
  LightJob light_{};

  // The queue of cell c is a ring of depth_ places from c*depth_ on. Beam has no constructor, so a
  // place takes no memory before a beam is in it.
  std::size_t depth_ = 0;
  std::unique_ptr<Beam[]> ring_;
  std::vector<std::uint32_t> first_, count_;
  // The links that the head beam of a cell was seen to need: as long as one of them is full there
  // is nothing to compute.
  std::vector<std::uint8_t> needs_;

  Tally tally_;
  std::int64_t absorbed_ = 0, escaped_ = 0, visits_ = 0, max_queue_ = 0;
};

}  // namespace rc2::cycle
