#include "sw/cycle/ray_engine.h"

#include "sw/cycle/ray_timing.h"

namespace rc2::cycle {

using ray_queue::kLaunched;

bool RayEngine::is_idle() const {
  const bool hits = hits_[0].meet || hits_[0].bend || hits_[1].meet || hits_[1].bend;
  return !launches_[0] && !launches_[1] && !read_ && !hits && !answer_;
}

void RayEngine::pass_turn(std::uint8_t& turn, const RayWorld& world) {
  turn = static_cast<std::uint8_t>((turn + 1) % world.units.arithmetic);
}

// The last stage first: each knows what the next one takes by what it had when the cycle began.
RayDeeds RayEngine::step(const RayWorld& world, const RayHeads& heads, std::int64_t cycle) {
  RayDeeds deeds;
  begin_child(world, heads, cycle, deeds);
  hit(world, cycle);
  Offer offer = read(world, cycle, deeds);
  const std::optional<Stage>& oldest = launches_[launch_turn_.out];
  if (oldest && cycle >= oldest->done_at && heads.has_launch_room)
    offer.begins = look_of(world.rays[oldest->ray].quadrant(), world);
  for (int i = 0, first = reader_turn_; i < world.units.looks; ++i)
    look(world, heads, (first + i) % world.units.looks, offer, cycle, deeds);
  launch(world, heads, cycle, deeds);
  return deeds;
}

void RayEngine::launch(const RayWorld& world, const RayHeads& heads, std::int64_t cycle,
                       RayDeeds& deeds) {
  std::optional<Stage>& unit = launches_[launch_turn_.in];
  if (heads.spawned == nullptr || unit) return;
  deeds.takes_spawned = true;
  RayWalk walk(heads.spawned->ray, world.n);
  walk.age = heads.spawned->age + ray_timing::launch(world.n);
  unit = {world.rays.add(walk), cycle + ray_timing::launch(world.n)};
  work(RayStage::launch) += ray_timing::launch(world.n);
  pass_turn(launch_turn_.in, world);
}

void RayEngine::hit(const RayWorld& world, std::int64_t cycle) {
  std::optional<Stage>& last = hits_[hit_turn_.out].bend;
  if (last && cycle >= last->done_at && !answer_) {
    const rays::Split& split = world.rays[last->ray].end()->split;
    answer_ = {last->ray, cycle, split.reflected, split.refracted};
    last.reset();
    pass_turn(hit_turn_.out, world);
  }
  for (auto& [meet, bend] : hits_) {
    if (!meet || cycle < meet->done_at || bend) continue;
    bend = {meet->ray, cycle + world.rays[meet->ray].end()->bend_cycles};
    meet.reset();
  }
}

// A ray that has been read goes on in the cycle of the verdict, or to the next stage in a later
// one.
RayEngine::Offer RayEngine::read(const RayWorld& world, std::int64_t cycle, RayDeeds& deeds) {
  if (!read_) return {true, 0, {}, {}};
  const Reading now = *read_;
  const RayWalk& walk = world.rays[now.ray];
  Offer offer{};
  if (cycle <= now.verdict_at) {
    offer.held = 1U << now.from;
    if (cycle < now.verdict_at) return offer;
    offer.reader_may_be_free = !walk.has_more();
    if (offer.reader_may_be_free) offer.blocks = look_of(walk.quadrant(), world);
    if (!walk.end()) {
      pass(world, now.ray, now.from, cycle, deeds);
      read_.reset();
    } else if (now.from != kLaunched) {
      deeds.ended = now.from;
    }
  } else {
    offer.reader_may_be_free = true;
    std::optional<Stage>& meet = hits_[hit_turn_.in].meet;
    if (!meet) {
      meet = {now.ray, cycle + walk.end()->meet_cycles};
      work(RayStage::meet) += walk.end()->meet_cycles;
      pass_turn(hit_turn_.in, world);
      read_.reset();
    }
  }
  return offer;
}

int RayEngine::look_of(unsigned quadrant, const RayWorld& world) {
  return static_cast<int>(quadrant) % world.units.looks;
}

// One ray: the one that begins here before those that pass.
void RayEngine::look(const RayWorld& world, const RayHeads& heads, int number, Offer& offer,
                     std::int64_t cycle, RayDeeds& deeds) {
  std::optional<Stage>& launch = launches_[launch_turn_.out];
  std::uint32_t waiting = 0;
  for (unsigned queue = 0; queue < kLaunched; ++queue)
    if (look_of(queue / 2, world) == number && heads.rays[queue] &&
        !world.rays[*heads.rays[queue]].is_sent())
      waiting |= 1U << queue;
  if (offer.begins == number) waiting |= 1U << kLaunched;
  waiting &= ~offer.held;
  if (!offer.reader_may_be_free) waiting &= ~to_read_;
  if (waiting == 0) return;

  Rotate& turn = look_turns_[static_cast<std::size_t>(number)];
  const bool begins = (waiting >> kLaunched & 1U) != 0;
  const unsigned from = begins ? kLaunched : turn.next(waiting);
  const std::uint32_t ray = begins ? launch->ray : *heads.rays[from];
  RayWalk& walk = world.rays[ray];
  if (!walk.is_probed()) walk.probe(world.columns, world.job, world.counts);
  const bool has_more_to_do = walk.reads() > 0 || walk.end();
  if (has_more_to_do ? read_.has_value() : offer.blocks == number) {
    if (has_more_to_do) to_read_ |= 1U << from;
    return;
  }
  to_read_ &= ~(1U << from);
  if (begins) {
    launch.reset();
    pass_turn(launch_turn_.out, world);
  } else {
    turn.take(1U << from);
  }
  ++work(RayStage::look);
  if (!has_more_to_do) {
    pass(world, ray, from, cycle, deeds);
    return;
  }
  const int reading = walk.reads() > 0 ? ray_timing::read(walk.reads()) : 0;
  walk.age += reading;
  work(RayStage::read) += reading;
  read_ = {ray, from, cycle + reading};
  reader_turn_ = (number + 1) % world.units.looks;
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
