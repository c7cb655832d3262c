// Random jobs for the whole machine, as a host does them, and what the golden model expects of
// them.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sw/golden/golden_machine.h"
#include "sw/machine/host_port.h"
#include "sw/machine/readback.h"
#include "tb/load/dice.h"
#include "tb/systemc/bench.h"
#include "tb/systemc/machine_unit.h"

namespace rc2::tb {

class MachineJob final : public Job {
 public:
  MachineJob(std::uint64_t seed, std::int64_t jobs);

  Scoreboard::Stream output(const StreamName& name) const override;

  /// Identifies the machine, then in each job loads random packets of all layers, reads them back,
  /// and twice lights them and reads that back.
  bool next(Bench& bench) override;

  /// Busy cycles of every load and light so far, in order.
  const std::vector<std::uint32_t>& busy_cycles() const { return busy_cycles_; }

 private:
  using Step = std::function<void(Bench&)>;

  void identify();
  void plan_job();
  void plan_light(glm::ivec3 source);
  void plan_read(ReadWhat what);
  // Waits until the status register has these bits and is not busy, then notes the busy cycles if
  // asked to.
  void plan_wait(std::uint32_t status, bool note);

  void poll(Bench& bench, std::uint32_t status, int polls);
  void load(Bench& bench);
  void ask(Bench& bench, ReadWhat what);
  static void write(Bench& bench, host_port::Register address, std::uint32_t value);
  static void read(Bench& bench, host_port::Register address, std::uint32_t expected);
  static void read_any(Bench& bench, host_port::Register address);
  std::optional<glm::ivec3> free_voxel();

  std::uint64_t seed_;
  std::int64_t jobs_, done_ = 0;
  facet::Dice dice_;
  WordFormat format_{kMachine};
  golden::GoldenMachine golden_{kMachine};
  facet::PacketStream packets_;
  std::deque<Step> plan_;
  std::vector<std::uint32_t> busy_cycles_;
};

}  // namespace rc2::tb
