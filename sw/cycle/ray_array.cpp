#include "sw/cycle/ray_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

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

RayArray::RayArray(int n, const Columns& columns, const RayUnits& units, const RayJob& job)
    : n_(n),
      job_(job),
      queues_(static_cast<std::size_t>(n) * n, job.queue),
      cells_(static_cast<std::size_t>(n) * n),
      world_{n, columns, units, job, rays_, result_.counts} {}

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
  traffic.units = world_.units;
  for (const Cell& cell : cells_) {
    for (std::size_t stage = 0; stage < kRayStages; ++stage)
      traffic.work[stage] = std::max(traffic.work[stage], cell.engine.work()[stage]);
    for (const std::int64_t sent : cell.sent) {
      traffic.messages += sent;
      traffic.busiest_link = std::max(traffic.busiest_link, sent);
    }
  }
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
  if (here.messages == 0 && here.home.empty() && here.engine.is_idle() && !here.launched) return;
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
  const auto spawned = front(cell, kSpawned);
  RayHeads heads;
  for (unsigned queue = kRays; queue < kLaunched; ++queue) heads.rays[queue] = front(cell, queue);
  heads.spawned = spawned ? &starts_[*spawned] : nullptr;
  heads.has_launch_room = !here.launched;
  heads.has_spawn_room = room(cell, kSpawned) > 0;
  const RayDeeds deeds = here.engine.step(world_, heads, cycle_);
  if (deeds.takes_spawned) {
    starts_.take(*spawned);
    let_go(cell, kSpawned);
  }
  if (deeds.ended) let_go(cell, *deeds.ended);
  if (deeds.launched) here.launched = deeds.launched;
  if (deeds.child) {
    here.begins_child = true;
    ++result_.traffic.run_on;
    ++rays_left_;
    spawn(cell, starts_.add(*deeds.child));
  }
  if (!here.answer && here.engine.answer(cycle_) != nullptr) answer(cell);
}

// The answer is there, and with it those new rays for which there was no room.
void RayArray::answer(std::size_t cell) {
  Cell& here = cells_[cell];
  const RayEngine::Answer& now = *here.engine.answer(cycle_);
  const RayWalk walk = rays_.take(now.ray);
  const RayEnd& end = *walk.end();
  Answer message{end.hit, {}};
  if (now.reflected) message.onwards.push_back({*now.reflected, walk.age - 1});
  if (now.refracted) message.onwards.push_back({*now.refracted, walk.age});
  RayCounts& counts = result_.counts;
  ++(end.hit.facet == RayHit::kNoFacet ? counts.escaped : counts.hits);
  counts.rescued += end.is_rescued ? 1 : 0;
  counts.too_light += end.split.too_light;
  counts.too_deep += end.split.too_deep;
  const glm::ivec2 way = glm::abs(end.hit.ray.home - place(cell));
  result_.traffic.latency = std::max(result_.traffic.latency, walk.age + way.x + way.y + 1);
  here.answer = answers_.add(std::move(message));
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
  ++cells_[cell].sent[way];
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
  const std::vector<RayBegin>& onwards = answers_[handle].onwards;
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

void RayArray::wait_at_home(std::size_t cell, const RayBegin& start) {
  std::deque<std::uint32_t>& home = cells_[cell].home;
  home.push_back(starts_.add(start));
  ++rays_left_;
  result_.traffic.max_stack =
      std::max(result_.traffic.max_stack, static_cast<std::int64_t>(home.size()));
}

std::optional<std::uint32_t> RayArray::front(std::size_t cell, unsigned sender) const {
  const Cell& here = cells_[cell];
  if (sender == kLaunched) return here.launched;
  if (sender == kOwnAnswer) return here.answer;
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
    if (!walk.may_go(cycle_)) return std::nullopt;
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
    here.answer.reset();
    here.engine.let_answer_go();
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
