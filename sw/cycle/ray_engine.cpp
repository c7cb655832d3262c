#include "sw/cycle/ray_engine.h"

#include "sw/cycle/ray_timing.h"

namespace rc2::cycle {

using ray_queue::kLaunched;

// The last stage first: each knows what the next one takes by what it had when the cycle began.
RayDeeds RayEngine::step(const RayWorld& world, const RayHeads& heads, std::int64_t cycle) {
  RayDeeds deeds;
  begin_child(world, heads, cycle, deeds);
  const bool bend_leaves = bend_ && cycle >= bend_->done_at && !answer_;
  const bool meet_leaves = meet_ && cycle >= meet_->done_at && (!bend_ || bend_leaves);
  if (bend_leaves) {
    const rays::Split& split = world.rays[bend_->ray].end()->split;
    answer_ = {bend_->ray, cycle, split.reflected, split.refracted};
    bend_.reset();
  }
  if (meet_leaves) {
    bend_ = {meet_->ray, cycle + world.rays[meet_->ray].end()->bend_cycles};
    meet_.reset();
  }
  const Reader reader = read(world, !meet_, cycle, deeds);
  look(world, heads, reader, cycle, deeds);
  if (heads.spawned != nullptr && !launch_) {
    deeds.takes_spawned = true;
    RayWalk walk(heads.spawned->ray, world.n);
    walk.age = heads.spawned->age + ray_timing::launch(world.n);
    launch_ = {world.rays.add(walk), cycle + ray_timing::launch(world.n)};
    work(RayStage::launch) += ray_timing::launch(world.n);
  }
  return deeds;
}

// A ray that has been read goes on in the cycle of the verdict, or to the next stage in a later
// one.
RayEngine::Reader RayEngine::read(const RayWorld& world, bool meet_takes, std::int64_t cycle,
                                  RayDeeds& deeds) {
  if (!read_) return {true, true, false, 0};
  const Reading now = *read_;
  const RayWalk& walk = world.rays[now.ray];
  Reader reader{};
  if (cycle <= now.verdict_at) {
    reader.held = 1U << now.from;
    if (cycle < now.verdict_at) return reader;
    reader.may_be_free = reader.writes = !walk.has_more();
    if (!walk.end()) {
      pass(world, now.ray, now.from, cycle, deeds);
      read_.reset();
    } else if (now.from != kLaunched) {
      deeds.ended = now.from;
    }
  } else {
    reader.may_be_free = true;
    if (meet_takes) {
      meet_ = {now.ray, cycle + walk.end()->meet_cycles};
      work(RayStage::meet) += walk.end()->meet_cycles;
      read_.reset();
    }
  }
  reader.is_free = !read_;
  return reader;
}

// One ray: the one that begins here before those that pass.
void RayEngine::look(const RayWorld& world, const RayHeads& heads, const Reader& reader,
                     std::int64_t cycle, RayDeeds& deeds) {
  std::uint32_t waiting = 0;
  for (unsigned queue = 0; queue < kLaunched; ++queue)
    if (heads.rays[queue] && !world.rays[*heads.rays[queue]].is_sent()) waiting |= 1U << queue;
  if (launch_ && cycle >= launch_->done_at && heads.has_launch_room) waiting |= 1U << kLaunched;
  waiting &= ~reader.held;
  if (!reader.may_be_free) waiting &= ~to_read_;
  if (waiting == 0) return;

  const bool begins = (waiting >> kLaunched & 1U) != 0;
  const unsigned from = begins ? kLaunched : turn_.next(waiting);
  const std::uint32_t ray = begins ? launch_->ray : *heads.rays[from];
  RayWalk& walk = world.rays[ray];
  if (!walk.is_probed()) walk.probe(world.columns, world.job, world.counts);
  const bool has_more_to_do = walk.reads() > 0 || walk.end();
  if (has_more_to_do ? !reader.is_free : reader.writes) {
    if (has_more_to_do) to_read_ |= 1U << from;
    return;
  }
  to_read_ &= ~(1U << from);
  if (begins)
    launch_.reset();
  else
    turn_.take(1U << from);
  ++work(RayStage::look);
  if (!has_more_to_do) {
    pass(world, ray, from, cycle, deeds);
    return;
  }
  const int reading = walk.reads() > 0 ? ray_timing::read(walk.reads()) : 0;
  walk.age += reading;
  work(RayStage::read) += reading;
  read_ = {ray, from, cycle + reading};
  if (!walk.end()) return;
  walk.age += 1 + walk.end()->meet_cycles + walk.end()->bend_cycles + ray_timing::kAnswer;
  ++work(RayStage::read);
  if (reading == 0 && from != kLaunched) deeds.ended = from;
}

void RayEngine::pass(const RayWorld& world, std::uint32_t ray, unsigned from, std::int64_t cycle,
                     RayDeeds& deeds) {
  RayWalk& walk = world.rays[ray];
  walk.send(cycle + 1);
  walk.age += 2;
  if (from == kLaunched) deeds.launched = ray;
}

// A new ray begins where its parent has ended, if there is room; the parent never waits for it.
void RayEngine::begin_child(const RayWorld& world, const RayHeads& heads, std::int64_t cycle,
                            RayDeeds& deeds) {
  if (!answer_) return;
  const std::int64_t since = cycle - answer_->taken;
  if (since != ray_timing::kMirrored && since != ray_timing::kCleared) return;
  std::optional<rays::Ray>& child =
      since == ray_timing::kMirrored ? answer_->reflected : answer_->refracted;
  const RayWalk& walk = world.rays[answer_->ray];
  if (!child || !walk.is_here(*child) || !heads.has_spawn_room) return;
  deeds.child = RayBegin{*child, walk.age + since - ray_timing::kCleared};
  child.reset();
}

const RayEngine::Answer* RayEngine::answer(std::int64_t cycle) const {
  return answer_ && cycle >= answer_->taken + ray_timing::kAnswer ? &*answer_ : nullptr;
}

}  // namespace rc2::cycle
