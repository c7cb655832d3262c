#include "sw/cycle/diffuser.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "sw/cycle/bits.h"
#include "sw/cycle/splitter.h"

namespace rc2::cycle {

Diffuser::Diffuser(int n, Columns& columns, Router& router)
    : n_(n),
      columns_(columns),
      router_(router),
      first_(columns.size()),
      count_(columns.size()),
      needs_(columns.size()) {
  at_.reserve(columns.size());
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) at_.emplace_back(x, y);
  }
}

void Diffuser::start(const LightJob& light) {
  light_ = light;
  const auto depth = static_cast<std::size_t>(light.fa);
  if (depth != depth_) {
    ring_.reset(new (std::nothrow) Beam[depth * columns_.size()]);
    if (!ring_) {
      throw Error(
          fmt::format("there is no memory for the queues of {} cells with FA = {}; choose "
                      "a smaller FA",
                      columns_.size(), light.fa));
    }
    depth_ = depth;
  }
  std::fill(first_.begin(), first_.end(), 0);
  std::fill(count_.begin(), count_.end(), 0);
  std::fill(needs_.begin(), needs_.end(), 0);
  tally_ = {};
  absorbed_ = escaped_ = visits_ = max_queue_ = 0;
}

bool Diffuser::step(std::size_t cell, std::int64_t cycle) {
  const bool room = count_[cell] < depth_;
  const Served served = count_[cell] != 0 ? serve(cell, cycle) : Served{};
  const bool takes = room && !served.own_child && router_.waiting(cell);
  if (takes) push(cell, router_.take(cell));
  max_queue_ = std::max<std::int64_t>(max_queue_, count_[cell]);
  return served.something || takes;
}

Diffuser::Served Diffuser::serve(std::size_t cell, std::int64_t cycle) {
  Beam& beam = ring_[cell * depth_ + first_[cell]];
  if (columns_.occupied(cell, beam.z)) {
    absorb(cell, cycle);
    return {true, false};
  }
  if ((needs_[cell] & router_.full_links(cell)) != 0) return {};

  const Split s = split(beam, at_[cell].x, at_[cell].y, n_, light_);
  needs_[cell] = s.send;
  if ((s.send & router_.full_links(cell)) != 0) return {};
  needs_[cell] = 0;

  for (unsigned links = s.send; links != 0; links = without_first(links)) {
    router_.send(cell, first_of(links), s.child(first_of(links)));
  }
  escaped_ += s.served - s.kept;
  tally_.finish(cycle, at_[cell].x, at_[cell].y, s.served - s.kept);
  if (s.more) {
    beam = s.remainder();
  } else {
    pop(cell);
  }
  if (s.own) push(cell, s.own_child());
  return {true, s.own};
}

void Diffuser::absorb(std::size_t cell, std::int64_t cycle) {
  const Beam& beam = head(cell);
  const std::int64_t targets = beam.u.extent() * beam.v.extent();
  columns_.light(cell, beam.z, targets);
  absorbed_ += targets;
  tally_.finish(cycle, at_[cell].x, at_[cell].y, targets);
  pop(cell);
}

void Diffuser::push(std::size_t cell, const Beam& beam) {
  std::size_t place = first_[cell] + std::size_t{count_[cell]};
  if (place >= depth_) place -= depth_;
  ring_[cell * depth_ + place] = beam;
  ++count_[cell];
}

void Diffuser::pop(std::size_t cell) {
  ++visits_;
  --count_[cell];
  // An empty queue starts anew in its first place, which is likely in the cache.
  first_[cell] = count_[cell] == 0 || first_[cell] + 1 == depth_ ? 0 : first_[cell] + 1;
}

}  // namespace rc2::cycle
