#include "sw/cycle/ray_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sw/cycle/cell.h"

namespace rc2::cycle {

using namespace ray_queue;

namespace {

bool is_of_rays(unsigned queue) { return queue <= kSpawned; }
bool is_answer(unsigned queue) { return queue >= kAnswersXy && queue < kStarts; }

constexpr std::uint32_t kRayMask = (1U << (kSpawned + 1)) - 1;
constexpr std::uint32_t kAnswerMask = (1U << kStarts) - (1U << kAnswersXy);

}  // namespace

RayArray::RayArray(int n, const Columns& columns, const RayJob& job)
    : n_(n),
      columns_(columns),
      job_(job),
      queues_(static_cast<std::size_t>(n) * n, job.queue),
      cells_(static_cast<std::size_t>(n) * n) {}

RayResult RayArray::run(const Progress& progress) {
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const rays::Ray first = first_ray(job_, place(cell), n_);
    if (first.direction != glm::ivec3(0)) wait_at_home(cell, {first, 0});
  }
  const std::int64_t rays = at_home_;
  std::int64_t last_move = 0;
  while (at_home_ > 0 || !rays_.empty() || !answers_.empty() || !starts_.empty()) {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
      if (cells_[cell].messages > 0 || !cells_[cell].stack.empty()) serve(cell);
    if (queues_.step() > 0) last_move = cycle_;
    // A probe is at work for n cycles at most.
    if (cycle_ - std::max(last_move, last_probe_) > n_)
      throw std::logic_error(fmt::format("the array blocks in cycle {}: no ray can move", cycle_));
    ++cycle_;
    if (progress && cycle_ % 64 == 0)
      progress("rays", cycle_,
               static_cast<double>(result_.traffic.answers) /
                   static_cast<double>(result_.counts.total() + at_home_));
  }
  RayTraffic& traffic = result_.traffic;
  traffic.cycles = cycle_;
  for (const Cell& cell : cells_) traffic.busiest = std::max(traffic.busiest, cell.probe_cycles);
  const std::int64_t begun = result_.counts.total();
  if (begun != traffic.answers || begun != rays + traffic.run_on + traffic.sent_again)
    throw std::logic_error(
        fmt::format("rays are lost: {} begun, {} came home", begun, traffic.answers));
  sort_hits(result_.hits);
  return std::move(result_);
}

void RayArray::serve(std::size_t cell) {
  cells_[cell].room_to_spawn = queues_.room(RayQueues::number(cell, kSpawned));
  probe(cell);
  end_ray(cell);
  for (unsigned way = kEast; way < kHere; ++way) drive_link(cell, way);
  take_home(cell);
  begin_rays(cell);
}

template <typename Test>
std::uint32_t RayArray::those(unsigned first, unsigned count, Test test) const {
  std::uint32_t found = 0;
  for (unsigned queue = first; queue < first + count; ++queue)
    if (test(queue)) found |= 1U << queue;
  return found;
}

// One ray each time, those that start here before those that pass.
void RayArray::probe(std::size_t cell) {
  Cell& here = cells_[cell];
  if (cycle_ < here.probing_until) return;
  const std::uint32_t waiting = those(kRays, kSpawned + 1, [&](unsigned queue) {
    const std::size_t number = RayQueues::number(cell, queue);
    return !queues_.empty(number) && !rays_[queues_.front(number)].is_probed();
  });
  if (waiting == 0) return;
  const bool is_start = (waiting >> kSpawned & 1U) != 0;
  const unsigned queue = is_start ? kSpawned : here.probe_turn.take(waiting);
  RayWalk& walk = rays_[queues_.front(RayQueues::number(cell, queue))];
  const int cycles = walk.probe(columns_, job_, result_.counts);
  walk.ready_at = cycle_ + cycles - 1;
  here.probing_until = cycle_ + cycles;
  here.probe_cycles += cycles;
  last_probe_ = cycle_;
}

// A ray that has ended waits for nothing but room for its answer.
void RayArray::end_ray(std::size_t cell) {
  const std::uint32_t ended = those(kRays, kSpawned + 1, [&](unsigned queue) {
    const std::size_t number = RayQueues::number(cell, queue);
    if (queues_.empty(number)) return false;
    const RayWalk& walk = rays_[queues_.front(number)];
    return walk.is_probed() && walk.end() && cycle_ >= walk.ready_at;
  });
  if (ended == 0) return;
  const auto room = [&](unsigned answers) {
    return queues_.room(RayQueues::number(cell, answers + kHere));
  };
  const unsigned emptier = room(kAnswersXy) >= room(kAnswersYx) ? kAnswersXy : kAnswersYx;
  if (room(emptier) > 0) answer(cell, cells_[cell].end_turn.take(ended), emptier);
}

// A new ray that finds no room goes home with the answer: its parent never waits for it.
void RayArray::answer(std::size_t cell, unsigned queue, unsigned answers) {
  const RayWalk walk = rays_.take(queues_.front(RayQueues::number(cell, queue)));
  pop(cell, queue);
  const RayEnd& end = *walk.end();
  Answer message{end.hit, {}};
  for (const auto& child : {end.split.reflected, end.split.refracted}) {
    if (!child) continue;
    const bool is_here = glm::ivec2(rays::voxel_of(child->origin)) == place(cell);
    if (is_here && cells_[cell].room_to_spawn > 0) {
      spawn(cell, {*child, walk.age});
      ++result_.traffic.run_on;
    } else {
      message.onwards.push_back({*child, walk.age});
    }
  }
  RayCounts& counts = result_.counts;
  ++(end.hit.facet == RayHit::kNoFacet ? counts.escaped : counts.hits);
  counts.rescued += end.is_rescued ? 1 : 0;
  counts.too_light += end.split.too_light;
  counts.too_deep += end.split.too_deep;
  const glm::ivec2 home = glm::abs(end.hit.ray.home - place(cell));
  result_.traffic.latency = std::max(result_.traffic.latency, walk.age + home.x + home.y);
  push(cell, answers + kHere, answers_.add(std::move(message)));
}

// Answers before starts before rays: what is nearer to its end makes room.
void RayArray::drive_link(std::size_t cell, unsigned way) {
  std::int64_t rays_that_wish = 0;
  const std::uint32_t able = those(0, kCount, [&](unsigned queue) {
    if (wish(cell, queue) != way) return false;
    if (is_of_rays(queue)) ++rays_that_wish;
    return queues_.room(next_queue(cell, queue, way)) > 0;
  });
  result_.traffic.waits += rays_that_wish;
  if (able == 0) return;
  std::uint32_t first = able & kAnswerMask;
  if (first == 0) first = able & ~kRayMask;
  if (first == 0) first = able;
  const unsigned queue = cells_[cell].link_turn[way].take(first);
  const std::uint32_t handle = queues_.front(RayQueues::number(cell, queue));
  const std::size_t to = next_queue(cell, queue, way);
  if (is_of_rays(queue)) {
    rays_[handle].advance();
    ++result_.traffic.hops;
    --result_.traffic.waits;
  }
  pop(cell, queue);
  push(to / kCount, static_cast<unsigned>(to % kCount), handle);
}

void RayArray::take_home(std::size_t cell) {
  const std::uint32_t arrived = those(kAnswersXy, kStarts - kAnswersXy,
                                      [&](unsigned queue) { return wish(cell, queue) == kHere; });
  if (arrived == 0) return;
  const unsigned queue = cells_[cell].home_turn.take(arrived);
  const Answer message = answers_.take(queues_.front(RayQueues::number(cell, queue)));
  pop(cell, queue);
  result_.hits.push_back(message.hit);
  ++result_.traffic.answers;
  for (const Start& start : message.onwards) {
    wait_at_home(cell, start);
    ++result_.traffic.sent_again;
  }
}

void RayArray::begin_rays(std::size_t cell) {
  Cell& here = cells_[cell];
  const std::uint32_t arrived =
      those(kStarts, kCount - kStarts, [&](unsigned queue) { return wish(cell, queue) == kHere; });
  if (arrived != 0 && here.room_to_spawn > 0) {
    const unsigned queue = here.start_turn.take(arrived);
    spawn(cell, starts_.take(queues_.front(RayQueues::number(cell, queue))));
    pop(cell, queue);
  }
  if (here.stack.empty() || queues_.room(RayQueues::number(cell, kStarts + kHere)) == 0) return;
  push(cell, kStarts + kHere, starts_.add(here.stack.back()));
  here.stack.pop_back();
  --at_home_;
}

void RayArray::spawn(std::size_t cell, const Start& start) {
  --cells_[cell].room_to_spawn;
  ++result_.counts.issued[static_cast<std::size_t>(rays::depth_of(start.ray.node))];
  RayWalk walk(start.ray, n_);
  walk.age = start.age;
  push(cell, kSpawned, rays_.add(walk));
}

void RayArray::wait_at_home(std::size_t cell, const Start& start) {
  std::vector<Start>& stack = cells_[cell].stack;
  stack.push_back(start);
  ++at_home_;
  result_.traffic.max_stack =
      std::max(result_.traffic.max_stack, static_cast<std::int64_t>(stack.size()));
}

std::optional<unsigned> RayArray::wish(std::size_t cell, unsigned queue) {
  const std::size_t number = RayQueues::number(cell, queue);
  if (queues_.empty(number)) return std::nullopt;
  const std::uint32_t handle = queues_.front(number);
  if (is_of_rays(queue)) {
    const RayWalk& walk = rays_[handle];
    if (!walk.is_probed() || walk.end() || cycle_ < walk.ready_at) return std::nullopt;
    return way_along(walk.axis(), walk.step());
  }
  if (is_answer(queue))
    return way_to(place(cell), answers_[handle].hit.ray.home, queue < kAnswersYx);
  return way_to(place(cell), rays::voxel_of(starts_[handle].ray.origin), true);
}

std::size_t RayArray::next_queue(std::size_t cell, unsigned queue, unsigned way) {
  const std::size_t to = neighbour(cell, way, n_);
  if (is_of_rays(queue)) {
    const unsigned quadrant = rays_[queues_.front(RayQueues::number(cell, queue))].quadrant();
    return RayQueues::number(to, kRays + 2 * quadrant + (way >= kNorth ? 1U : 0U));
  }
  const unsigned of = is_answer(queue) ? (queue < kAnswersYx ? kAnswersXy : kAnswersYx) : kStarts;
  return RayQueues::number(to, of + way);
}

glm::ivec2 RayArray::place(std::size_t cell) const {
  const auto n = static_cast<std::size_t>(n_);
  return {static_cast<int>(cell % n), static_cast<int>(cell / n)};
}

void RayArray::pop(std::size_t cell, unsigned queue) {
  queues_.pop(RayQueues::number(cell, queue));
  --cells_[cell].messages;
}

void RayArray::push(std::size_t cell, unsigned queue, std::uint32_t handle) {
  queues_.push(RayQueues::number(cell, queue), handle);
  ++cells_[cell].messages;
}

}  // namespace rc2::cycle
