// Input and output buffers of every cell and its choice of one arrival per cycle
// (rtl/net/rc2_router.sv, rc2_link.sv, rtl/parts/rc2_slot.sv).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sw/cycle/bits.h"
#include "sw/cycle/links.h"
#include "sw/cycle/rotate.h"
#include "sw/cycle/source.h"

namespace rc2::cycle {

/// A cycle has two phases. First the links move beams into empty input buffers, by the registers
/// of the cycle before, and what comes in stays apart; then each cell serves, and merges what came
/// in. So the order of the cells does not matter in either phase.
class Router {
 public:
  explicit Router(int n);

  /// Empties all buffers and puts a new light into its cell.
  void start(const LightJob& light);

  bool busy(std::size_t cell) const {
    return (slots_[cell] | incoming_[cell] | links_[cell]) != 0 || has_source(cell);
  }

  /// The beam in a full output buffer, and the end of it when the neighbour has taken it.
  const Beam& on_link(std::size_t cell, unsigned link) const { return buffers_[cell].link[link]; }
  void release(std::size_t cell, unsigned link) {
    links_[cell] &= static_cast<std::uint8_t>(~(1U << link));
  }

  /// Whether an input buffer has room, and what comes into it.
  bool has_room(std::size_t cell, unsigned slot) const { return (slots_[cell] >> slot & 1U) == 0; }
  void receive(std::size_t cell, unsigned slot, const Beam& beam) {
    buffers_[cell].slot[slot] = beam;
    incoming_[cell] |= static_cast<std::uint8_t>(1U << slot);
  }

  // ---- Phase 1 ---------------------------------------------------------------------------
  /// Moves the beams on the cell's links whose neighbour has room; calls `reached(neighbour)` for
  /// each. Returns whether there was one.
  template <typename Reached>
  bool move_links(std::size_t cell, Reached reached) {
    bool moved = false;
    for (unsigned full = links_[cell]; full != 0; full = without_first(full)) {
      const unsigned link = first_of(full);
      const std::size_t neighbour = cell + static_cast<std::size_t>(offset_[link]);
      const unsigned slot = opposite(link);
      if (!has_room(neighbour, slot)) continue;
      receive(neighbour, slot, on_link(cell, link));
      release(cell, link);
      reached(neighbour);
      moved = true;
    }
    return moved;
  }

  // ---- Phase 2 ---------------------------------------------------------------------------
  /// Output buffers that cannot be written in this cycle.
  std::uint8_t full_links(std::size_t cell) const { return links_[cell]; }

  void send(std::size_t cell, unsigned link, const Beam& beam) {
    buffers_[cell].link[link] = beam;
    links_[cell] |= static_cast<std::uint8_t>(1U << link);
  }

  /// True if a beam wants to enter the queue.
  bool waiting(std::size_t cell) const { return slots_[cell] != 0 || has_source(cell); }

  /// Takes one of the beams that want to enter.
  Beam take(std::size_t cell);

  /// Ends the cell's cycle: what came in is there from the next cycle on.
  void merge(std::size_t cell) {
    slots_[cell] |= incoming_[cell];
    incoming_[cell] = 0;
  }

 private:
  struct Buffers {
    std::array<Beam, kLinks> slot, link;
  };

  bool has_source(std::size_t cell) const { return cell == source_cell_ && source_.active(); }

  int n_;
  std::array<std::ptrdiff_t, kLinks> offset_{};  // from a cell to its neighbours
  std::vector<Buffers> buffers_;
  std::vector<std::uint8_t> slots_, incoming_, links_;  // bit d: the buffer of direction d is full
  std::vector<Rotate> rotate_;
  Source source_;
  std::size_t source_cell_ = 0;
};

}  // namespace rc2::cycle
