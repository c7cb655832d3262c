#include "sw/cycle/ray_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "sw/cycle/ray_timing.h"

namespace rc2::cycle {

using namespace ray_queue;

namespace {

bool is_of_rays(unsigned sender) { return sender <= kLaunched; }
bool is_answer(unsigned sender) { return sender >= kAnswers && sender < kStarts; }

constexpr std::uint32_t kRayMask = (1U << kAnswers) - 1;
constexpr std::uint32_t kAnswerMask = (1U << kStarts) - (1U << kAnswers);

// Cycles in which no message moves because cells are at work: more than any ray can take.
constexpr std::int64_t kPatience = 1000;

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
  const std::int64_t rays = rays_left_;
  std::int64_t last_move = 0;
  while (rays_left_ > 0) {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) serve(cell);
    if (queues_.step() > 0) last_move = cycle_;
    if (cycle_ - last_move > kPatience + n_)
      throw std::logic_error(fmt::format("the array blocks in cycle {}: no ray can move", cycle_));
    ++cycle_;
    if (progress && cycle_ % 64 == 0)
      progress("rays", cycle_,
               static_cast<double>(result_.traffic.answers) /
                   static_cast<double>(result_.traffic.answers + rays_left_));
  }
  RayTraffic& traffic = result_.traffic;
  traffic.cycles = cycle_;
  for (const Cell& cell : cells_) traffic.busiest = std::max(traffic.busiest, cell.work_cycles);
  const std::int64_t begun = result_.counts.total();
  if (begun != traffic.answers || begun != rays + traffic.run_on + traffic.sent_again)
    throw std::logic_error(
        fmt::format("rays are lost: {} begun, {} came home", begun, traffic.answers));
  sort_hits(result_.hits);
  return std::move(result_);
}

// Each step looks at what was there when the cycle began: what one does shows to none after it.
void RayArray::serve(std::size_t cell) {
  Cell& here = cells_[cell];
  if (here.messages == 0 && here.home.empty() && !here.work && !here.launched) return;
  work(cell);
  here.wishes.fill(0);
  for (unsigned sender = 0; sender < kSenders; ++sender)
    if (const auto way = wish(cell, sender)) here.wishes[*way] |= 1U << sender;
  for (unsigned way = kEast; way < kHere; ++way) drive_link(cell, way);
  begin_ray(cell);
  take_home(cell);
}

void RayArray::work(std::size_t cell) {
  Cell& here = cells_[cell];
  here.begins_child = false;
  if (!here.work) {
    take_up(cell);
    return;
  }
  ++here.work_cycles;
  Work& now = *here.work;
  if (cycle_ == now.pass_at) {
    rays_[now.ray].ready_at = cycle_ + 1;
    if (now.queue == kSpawned) here.launched = now.ray;
    here.work.reset();
    return;
  }
  if (cycle_ == now.end_at && now.queue != kSpawned) let_go(cell, now.queue);
  if (cycle_ == now.answer_at - 2) begin_child(cell, now.reflected);
  if (cycle_ == now.answer_at - 1) begin_child(cell, now.refracted);
  if (cycle_ == now.answer_at) answer(cell);
}

// One ray each time, those that begin here before those that pass.
void RayArray::take_up(std::size_t cell) {
  Cell& here = cells_[cell];
  const auto spawned = front(cell, kSpawned);
  std::int64_t look = cycle_;  // the cycle in which the column is looked into
  Work now{0, kSpawned};
  if (spawned && !here.launched) {
    const Start start = starts_.take(*spawned);
    RayWalk walk(start.ray, n_);
    walk.age = start.age;
    now.ray = rays_.add(walk);
    let_go(cell, kSpawned);
    look += ray_timing::begin(n_);
  } else {
    std::uint32_t waiting = 0;
    for (unsigned queue = kRays; queue < kLaunched; ++queue) {
      const auto ray = front(cell, queue);
      if (ray && !rays_[*ray].is_probed()) waiting |= 1U << queue;
    }
    if (waiting == 0) return;
    now.queue = here.probe_turn.take(waiting);
    now.ray = *front(cell, now.queue);
  }
  ++here.work_cycles;
  RayWalk& walk = rays_[now.ray];
  walk.ready_at = std::numeric_limits<std::int64_t>::max();
  const int reads = walk.probe(columns_, job_, result_.counts);
  const std::int64_t read = look + (reads > 0 ? ray_timing::read(reads) : 0);
  if (!walk.end()) {
    if (reads == 0 && now.queue != kSpawned) {  // nothing on its way: on it goes at once
      walk.ready_at = cycle_ + 1;
      walk.age += 2;
      return;
    }
    now.pass_at = read + 1;
    walk.age += now.pass_at - cycle_ + 2;
  } else {
    const RayEnd& end = *walk.end();
    now.end_at = walk.is_beyond() ? read + 1 : read;
    now.answer_at = now.end_at + end.cycles + 1;
    now.reflected = end.split.reflected;
    now.refracted = end.split.refracted;
    walk.age += now.answer_at - cycle_;
  }
  here.work = now;
}

// A new ray begins where its parent has ended, if there is room; the parent never waits for it.
void RayArray::begin_child(std::size_t cell, std::optional<rays::Ray>& child) {
  if (!child || glm::ivec2(rays::voxel_of(child->origin)) != place(cell)) return;
  if (room(cell, kSpawned) == 0) return;
  cells_[cell].begins_child = true;
  ++result_.traffic.run_on;
  ++rays_left_;
  spawn(cell, starts_.add({*child, rays_[cells_[cell].work->ray].age - 1}));
  child.reset();
}

// The answer is there, and with it those new rays for which there was no room.
void RayArray::answer(std::size_t cell) {
  Work& now = *cells_[cell].work;
  const RayWalk walk = rays_.take(now.ray);
  const RayEnd& end = *walk.end();
  Answer message{end.hit, {}};
  for (const auto& child : {now.reflected, now.refracted})
    if (child) message.onwards.push_back({*child, walk.age - 1});
  RayCounts& counts = result_.counts;
  ++(end.hit.facet == RayHit::kNoFacet ? counts.escaped : counts.hits);
  counts.rescued += end.is_rescued ? 1 : 0;
  counts.too_light += end.split.too_light;
  counts.too_deep += end.split.too_deep;
  const glm::ivec2 way = glm::abs(end.hit.ray.home - place(cell));
  result_.traffic.latency = std::max(result_.traffic.latency, walk.age + way.x + way.y + 1);
  now.answer = answers_.add(std::move(message));
}

// Answers before starts before rays: what is nearer to its end makes room.
void RayArray::drive_link(std::size_t cell, unsigned way) {
  const std::uint32_t wishing = cells_[cell].wishes[way];
  if (wishing == 0) return;
  std::uint32_t able = 0;
  for (std::uint32_t rest = wishing; rest != 0; rest &= rest - 1) {
    const unsigned sender = first_of(rest);
    if (is_of_rays(sender)) ++result_.traffic.waits;
    if (queues_.room(next_queue(cell, sender, way)) > 0) able |= 1U << sender;
  }
  if (able == 0) return;
  std::uint32_t first = able & kAnswerMask;
  if (first == 0) first = able & ~kRayMask;
  if (first == 0) first = able;
  const unsigned sender = cells_[cell].link_turn[way].take(first);
  const std::uint32_t handle = *front(cell, sender);
  const std::size_t to = next_queue(cell, sender, way);
  if (is_of_rays(sender)) {
    rays_[handle].advance();
    ++result_.traffic.hops;
    --result_.traffic.waits;
  }
  let_go(cell, sender);
  push(to / kCount, static_cast<unsigned>(to % kCount), handle);
}

// A ray that has come to where it begins waits for room, and lets new ones go first.
void RayArray::begin_ray(std::size_t cell) {
  Cell& here = cells_[cell];
  if (room(cell, kSpawned) == 0 || here.begins_child) return;
  const std::uint32_t arrived = here.wishes[kHere] & ~(kRayMask | kAnswerMask);
  if (arrived == 0) return;
  const unsigned sender = here.start_turn.take(arrived);
  spawn(cell, *front(cell, sender));
  let_go(cell, sender);
}

// An answer a cycle, or in two cycles one that brings two rays.
void RayArray::take_home(std::size_t cell) {
  Cell& here = cells_[cell];
  unsigned sender = 0;
  if (here.held) {
    sender = *here.held;
  } else {
    const std::uint32_t arrived = here.wishes[kHere] & kAnswerMask;
    if (arrived == 0) return;
    sender = here.home_turn.take(arrived);
  }
  const std::uint32_t handle = *front(cell, sender);
  const std::vector<Start>& onwards = answers_[handle].onwards;
  const bool is_second = here.held.has_value();
  if (!onwards.empty()) {
    ++result_.traffic.sent_again;
    wait_at_home(cell, onwards[is_second ? 1 : 0]);
  }
  if (onwards.size() == 2 && !is_second) {
    here.held = sender;
    return;
  }
  here.held.reset();
  result_.hits.push_back(answers_.take(handle).hit);
  ++result_.traffic.answers;
  --rays_left_;
  let_go(cell, sender);
}

void RayArray::spawn(std::size_t cell, std::uint32_t start) {
  ++result_.counts.issued[static_cast<std::size_t>(rays::depth_of(starts_[start].ray.node))];
  push(cell, kSpawned, start);
}

void RayArray::wait_at_home(std::size_t cell, const Start& start) {
  std::deque<std::uint32_t>& home = cells_[cell].home;
  home.push_back(starts_.add(start));
  ++rays_left_;
  result_.traffic.max_stack =
      std::max(result_.traffic.max_stack, static_cast<std::int64_t>(home.size()));
}

std::optional<std::uint32_t> RayArray::front(std::size_t cell, unsigned sender) const {
  const Cell& here = cells_[cell];
  if (sender == kLaunched) return here.launched;
  if (sender == kOwnAnswer) {
    if (!here.work || here.work->answer_at == kNever || cycle_ < here.work->answer_at) return {};
    return here.work->answer;
  }
  if (sender == kHome) {
    if (here.home.empty()) return {};
    return here.home.front();
  }
  const std::size_t number = RayQueues::number(cell, sender);
  if (queues_.empty(number)) return {};
  return queues_.front(number);
}

std::optional<unsigned> RayArray::wish(std::size_t cell, unsigned sender) {
  const auto handle = front(cell, sender);
  if (!handle) return std::nullopt;
  if (is_of_rays(sender)) {
    const RayWalk& walk = rays_[*handle];
    if (!walk.is_probed() || walk.end() || cycle_ < walk.ready_at) return std::nullopt;
    return way_along(walk.axis(), walk.step());
  }
  if (is_answer(sender)) return way_to(place(cell), answers_[*handle].hit.ray.home, true);
  return way_to(place(cell), rays::voxel_of(starts_[*handle].ray.origin), true);
}

std::size_t RayArray::next_queue(std::size_t cell, unsigned sender, unsigned way) {
  const std::size_t to = neighbour(cell, way, n_);
  if (is_of_rays(sender)) {
    const unsigned quadrant = rays_[*front(cell, sender)].quadrant();
    return RayQueues::number(to, kRays + 2 * quadrant + (way >= kNorth ? 1U : 0U));
  }
  return RayQueues::number(to, (is_answer(sender) ? kAnswers : kStarts) + way);
}

void RayArray::let_go(std::size_t cell, unsigned sender) {
  Cell& here = cells_[cell];
  if (sender == kLaunched) {
    here.launched.reset();
  } else if (sender == kOwnAnswer) {
    here.work.reset();
  } else if (sender == kHome) {
    here.home.pop_front();
  } else {
    queues_.pop(RayQueues::number(cell, sender));
    --here.messages;
  }
}

void RayArray::push(std::size_t cell, unsigned queue, std::uint32_t handle) {
  queues_.push(RayQueues::number(cell, queue), handle);
  ++cells_[cell].messages;
}

glm::ivec2 RayArray::place(std::size_t cell) const {
  const auto n = static_cast<std::size_t>(n_);
  return {static_cast<int>(cell % n), static_cast<int>(cell / n)};
}

}  // namespace rc2::cycle
