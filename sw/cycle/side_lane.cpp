#include "sw/cycle/side_lane.h"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>

#include "sw/cycle/cell.h"

namespace rc2::cycle {
namespace {

// The one target that only x beams have: U = L and U = -L, a class of its own on the diagonals.
constexpr ClassSet kEdge = ClassSet{1} << 63;

// The first step's beams go both ways.
int ways(int offset) { return offset == 0 ? 2 : 1; }

}  // namespace

SideLane::SideLane(int n, Columns& columns)
    : n_(n),
      columns_(columns),
      cells_(columns.size()),
      held_(columns.size()),
      listed_(columns.size()) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    cells_[i].x = static_cast<std::uint16_t>(i % static_cast<std::size_t>(n));
    cells_[i].y = static_cast<std::uint16_t>(i / static_cast<std::size_t>(n));
  }
}

void SideLane::start(const LightJob& light, const Classes& classes,
                     const std::vector<Outlook>& outlooks) {
  light_ = light;
  classes_ = &classes;
  const auto depth = static_cast<std::size_t>(light.fa + 1) / 2;
  if (depth != depth_) {
    fifo_.assign(2 * depth * cells_.size(), {});
    depth_ = depth;
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell& cell = cells_[i];
    cell.beyond = outlooks[i].in(told(cell) - 1);
    cell.table_made = cell.serving = false;
    cell.first = cell.count = {};
  }
  std::fill(held_.begin(), held_.end(), 0);
  std::fill(listed_.begin(), listed_.end(), 0);
  active_.clear();
  tally_ = {};
  absorbed_ = escaped_ = skipped_ = visits_ = merged_ = max_queue_ = last_busy_ = 0;

  const auto source = cell_number(light.source.x, light.source.y, n_);
  Cell& cell = cells_[source];
  const int distance = light.target_distance;
  cell.serving = true;
  cell.beam = {{-distance, distance}, ClassSet{1} | kEdge, false};
  held_[source] = 1;
  reach(source);
}

int SideLane::steps(const Cell& cell) const {
  return std::max(std::abs(cell.x - light_.source.x), std::abs(cell.y - light_.source.y));
}

std::int64_t SideLane::weight(const Cell& cell, const ColumnBeam& beam) const {
  const int offset = beam.along_y ? cell.x - light_.source.x : cell.y - light_.source.y;
  return classes_->targets(steps(cell), offset, beam.u & ~kEdge) +
         ((beam.u & kEdge) != 0 ? ways(offset) : 0);
}

void SideLane::reach(std::size_t cell) {
  if (listed_[cell] == 0) {
    listed_[cell] = 1;
    active_.push_back(cell);
  }
}

bool SideLane::step(std::int64_t cycle) {
  arrivals_.clear();
  taken_.clear();
  bool moved = false;
  for (const std::size_t number : active_) {
    last_busy_ = std::max(last_busy_, cycle);
    const bool served = serve(number, cycle);
    const bool loaded = load(number, cycle);
    moved = moved || served || loaded;
  }
  for (const auto& [number, from] : taken_) {
    Cell& cell = cells_[number];
    cell.first[from] = static_cast<std::uint16_t>((cell.first[from] + 1U) % depth_);
    --cell.count[from];
  }
  for (const Arrival& arrival : arrivals_) {
    Cell& cell = cells_[arrival.cell];
    place(arrival.cell, arrival.from,
          (cell.first[arrival.from] + std::size_t{cell.count[arrival.from]}) % depth_) =
        arrival.beam;
    ++cell.count[arrival.from];
    reach(arrival.cell);
  }
  std::size_t kept = 0;
  for (const std::size_t number : active_) {
    const Cell& cell = cells_[number];
    held_[number] = cell.count[0] + cell.count[1] + (cell.serving ? 1U : 0U);
    max_queue_ = std::max<std::int64_t>(max_queue_, held_[number]);
    listed_[number] = held_[number] != 0 ? 1 : 0;
    if (listed_[number] != 0) active_[kept++] = number;
  }
  active_.resize(kept);
  return moved;
}

bool SideLane::serve(std::size_t number, std::int64_t cycle) {
  Cell& cell = cells_[number];
  if (!cell.serving || cycle < here(cell)) return false;
  const bool served = steps(cell) == 0 ? serve_source(cell, cycle) : serve_column(number, cycle);
  if (served) {
    ++visits_;
    // What is served is marked two cycles later.
    if (steps(cell) != 0) last_busy_ = std::max(last_busy_, cycle + 2);
  }
  return served;
}

// The light's own voxel is free; its beams along x leave first, then those along y.
bool SideLane::serve_source(Cell& cell, std::int64_t cycle) {
  if (!send(cell, cell.beam, cell.beam.v, cycle)) return false;
  cell.serving = !cell.beam.along_y;
  cell.beam.along_y = true;
  cell.beam.u = 1;
  return true;
}

bool SideLane::serve_column(std::size_t number, std::int64_t cycle) {
  Cell& cell = cells_[number];
  const int k = steps(cell), z = light_.source.z;
  const auto fill_table = [&](int first, std::int64_t when) {
    cell.table.fill(columns_, number, slope(cell), z, first, std::min(cell.beyond.max, z + k),
                    when);
  };
  if (!cell.table_made) {
    cell.table_made = true;
    fill_table(std::max(cell.beyond.min, z - k), told(cell) + 1);
  }
  if (cycle < cell.table.ready()) return false;
  const Targets beam = cell.beam.v;
  if (!cell.table.knows(beam.min)) {
    fill_table(z + slope(cell).offset(beam.min), cycle + 2);
    return false;
  }
  const auto [free, end] = cell.table.pass(beam);
  if (!free.none() && !send(cell, cell.beam, free, cycle)) return false;
  light(number, {beam.min, end});
  finish(cell, weight(cell, cell.beam) * (Targets{beam.min, end}.count() - free.count()), absorbed_,
         cycle);
  cell.beam.v.min = end + 1;
  cell.serving = !cell.beam.v.none();
  return true;
}

bool SideLane::send(const Cell& cell, const ColumnBeam& beam, const Targets& free,
                    std::int64_t cycle) {
  const int dx = cell.x - light_.source.x, dy = cell.y - light_.source.y;
  const int ahead = beam.along_y ? dy : dx, aside = beam.along_y ? dx : dy;
  const int k = steps(cell);
  const Classes::Cut& cut = classes_->cut(k, aside);
  const ClassSet edge = beam.u & kEdge, plain = beam.u & ~kEdge;
  const std::size_t before = arrivals_.size();
  std::int64_t sent = 0;
  const auto child = [&](int forward, int sideways, ClassSet u) {
    if (u == 0) return true;
    const int x = cell.x + (beam.along_y ? sideways : forward);
    const int y = cell.y + (beam.along_y ? forward : sideways);
    if (x < 0 || y < 0 || x >= n_ || y >= n_) return true;
    const auto to = cell_number(x, y, n_);
    const From from = sideways == 0 ? kStraight : kDiagonal;
    if (cells_[to].count[from] == depth_) return false;
    if (from == kStraight) u <<= classes_->cut(k + 1, aside).come;
    arrivals_.push_back({cell_number(cell.x, cell.y, n_), to, from, {free, u, beam.along_y}});
    sent += weight(cells_[to], arrivals_.back().beam);
    return true;
  };
  bool all = true;
  for (const int forward : {-1, 1}) {
    if (ahead != 0 && glm::sign(ahead) != forward) continue;
    all = all && child(forward, 0, staying(cut, plain));
    for (const int sideways : {-1, 1}) {
      if (aside != 0 && glm::sign(aside) != sideways) continue;
      const bool leaves = sideways < 0 ? cut.down : cut.up;
      all = all && child(forward, sideways, (leaves ? leaving(cut, plain) : 0) | edge);
    }
  }
  if (!all) {
    arrivals_.resize(before);
    return false;
  }
  finish(cell, (ways(ahead) * weight(cell, beam) - sent) * free.count(), escaped_, cycle);
  return true;
}

// All of them arrive, whether they end here or go on.
void SideLane::light(std::size_t number, const Targets& targets) {
  const Cell& cell = cells_[number];
  const Slope along = slope(cell);
  const std::int64_t each = weight(cell, cell.beam);
  const int last = light_.source.z + along.offset(targets.max);
  int z = columns_.next_occupied(number, light_.source.z + along.offset(targets.min));
  for (; z <= last && z < n_; z = columns_.next_occupied(number, z + 1)) {
    const Targets here = along.between(z - light_.source.z, z - light_.source.z);
    const Targets arrived{std::max(targets.min, here.min), std::min(targets.max, here.max)};
    columns_.light(number, z, each * arrived.count());
  }
}

void SideLane::finish(const Cell& cell, std::int64_t targets, std::int64_t& where,
                      std::int64_t cycle) {
  where += targets;
  tally_.finish(cycle, cell.x, cell.y, targets);
}

// What a beam has beyond the cube's top and bottom has left it, what it has beyond anything that
// could be lit is skipped.
bool SideLane::load(std::size_t number, std::int64_t cycle) {
  Cell& cell = cells_[number];
  if (cell.serving || cycle < here(cell) || (cell.count[0] == 0 && cell.count[1] == 0)) {
    return false;
  }
  ColumnBeam beam = take(number);
  const auto within = [&](const Targets& targets, const Extent& extent) {
    if (extent.none()) return Targets{0, -1};
    const Targets limits =
        slope(cell).between(extent.min - light_.source.z, extent.max - light_.source.z);
    return Targets{std::max(targets.min, limits.min), std::min(targets.max, limits.max)};
  };
  const std::int64_t each = weight(cell, beam);
  const Targets inside = within(beam.v, {0, n_ - 1});
  const Targets kept = within(inside, cell.beyond);
  finish(cell, each * (beam.v.count() - inside.count()), escaped_, cycle);
  finish(cell, each * (inside.count() - kept.count()), skipped_, cycle);
  beam.v = kept;
  cell.beam = beam;
  cell.serving = !kept.none();
  return true;
}

// The lower head of the two FIFOs, or both if they are at the same V targets.
ColumnBeam SideLane::take(std::size_t number) {
  const Cell& cell = cells_[number];
  const auto head = [&](From from) -> const ColumnBeam& {
    return place(number, from, cell.first[from]);
  };
  if (cell.count[kStraight] == 0 || cell.count[kDiagonal] == 0) {
    const From from = cell.count[kStraight] != 0 ? kStraight : kDiagonal;
    taken_.emplace_back(number, from);
    return head(from);
  }
  const ColumnBeam &a = head(kStraight), &b = head(kDiagonal);
  if (a.v.min == b.v.min && a.v.max == b.v.max) {
    taken_.emplace_back(number, kStraight);
    taken_.emplace_back(number, kDiagonal);
    ++merged_;
    return {a.v, a.u | b.u, a.along_y};
  }
  const bool first = a.v.min < b.v.min || (a.v.min == b.v.min && a.v.max < b.v.max);
  taken_.emplace_back(number, first ? kStraight : kDiagonal);
  return first ? a : b;
}

}  // namespace rc2::cycle
