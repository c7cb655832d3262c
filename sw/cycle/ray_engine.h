// What a cell does with rays, in stages that work side by side (rtl/rays/rc2_ray_engine.sv).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sw/cycle/ray_queues.h"
#include "sw/cycle/ray_walk.h"
#include "sw/cycle/rotate.h"

namespace rc2::cycle {

/// A ray and the age that it begins with.
struct RayBegin {
  rays::Ray ray;
  std::int64_t age;
};

/// What the engines of all cells look things up in.
struct RayWorld {
  int n;
  const Columns& columns;
  RayUnits units;
  const RayJob& job;
  Pool<RayWalk>& rays;
  RayCounts& counts;
};

/// What waits for the engine when the cycle begins.
struct RayHeads {
  std::array<std::optional<std::uint32_t>, ray_queue::kLaunched> rays{};
  const RayBegin* spawned = nullptr;  ///< the next ray that is to begin here
  bool has_launch_room = false;
  bool has_spawn_room = false;
};

/// What it does in the cycle.
struct RayDeeds {
  bool takes_spawned = false;
  std::optional<unsigned> ended{};          ///< the head of this queue goes no further
  std::optional<std::uint32_t> launched{};  ///< has begun here, and goes on
  std::optional<RayBegin> child{};          ///< is to begin here
};

class RayEngine {
 public:
  /// One cycle. A ray that goes on may do so from the next cycle on.
  RayDeeds step(const RayWorld& world, const RayHeads& heads, std::int64_t cycle);

  bool is_idle() const;

  /// The ray that is to be answered in this cycle, if there is one, and what it could not begin
  /// here.
  struct Answer {
    std::uint32_t ray;
    std::int64_t taken;  // when the last stage took it
    std::optional<rays::Ray> reflected, refracted;
  };
  const Answer* answer(std::int64_t cycle) const;
  void let_answer_go() { answer_.reset(); }

  /// Cycles that each stage cannot do without.
  const std::array<std::int64_t, kRayStages>& work() const { return work_; }

 private:
  struct Stage {
    std::uint32_t ray;
    std::int64_t done_at;
  };
  struct Reading {
    std::uint32_t ray;
    unsigned from;
    std::int64_t verdict_at;
  };
  // What the looks may do in a cycle.
  struct Offer {
    bool reader_may_be_free;    // told early in the cycle; whether it is, read_ says late
    std::uint32_t held;         // the reader has the head of this queue, one bit
    std::optional<int> blocks;  // the reader may pass a ray where this look would
    std::optional<int> begins;  // a ray may begin, and this look sees it
  };
  // The look that sees the rays of a quadrant.
  static int look_of(unsigned quadrant, const RayWorld& world);

  // Where a ray that goes no further meets a plane, and the new directions.
  struct HitUnit {
    std::optional<Stage> meet, bend;
  };
  // Units take rays by turns, and give them back in that order.
  struct Turn {
    std::uint8_t in = 0, out = 0;
  };
  static void pass_turn(std::uint8_t& turn, const RayWorld& world);

  void hit(const RayWorld& world, std::int64_t cycle);
  Offer read(const RayWorld& world, std::int64_t cycle, RayDeeds& deeds);
  void look(const RayWorld& world, const RayHeads& heads, int number, Offer& offer,
            std::int64_t cycle, RayDeeds& deeds);
  void launch(const RayWorld& world, const RayHeads& heads, std::int64_t cycle, RayDeeds& deeds);
  void pass(const RayWorld& world, std::uint32_t ray, unsigned from, std::int64_t cycle,
            RayDeeds& deeds);
  void begin_child(const RayWorld& world, const RayHeads& heads, std::int64_t cycle,
                   RayDeeds& deeds);

  std::int64_t& work(RayStage stage) { return work_[static_cast<std::size_t>(stage)]; }

  std::array<std::optional<Stage>, 2> launches_;
  std::array<HitUnit, 2> hits_;
  Turn launch_turn_, hit_turn_;
  std::optional<Reading> read_;
  std::optional<Answer> answer_;
  std::array<Rotate, 4> look_turns_;
  int reader_turn_ = 0;        // the look that has the reader first
  std::uint32_t to_read_ = 0;  // heads that are known to want the reader, one bit each
  std::array<std::int64_t, kRayStages> work_{};
};

}  // namespace rc2::cycle
