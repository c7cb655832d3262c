// Stands in for a Verilated library: the golden model with the fault that the environment names.
// A right machine cannot show that the program notices a wrong one.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <thread>

#include "sim/rtl_machine.h"
#include "sw/cycle/cycle_machine.h"
#include "sw/golden/golden_machine.h"

namespace rc2 {
namespace {

class FaultyMachine : public golden::GoldenMachine {
 public:
  FaultyMachine(const MachineConfig& config, std::string fault)
      : GoldenMachine(config), fault_(std::move(fault)) {}

  LoadResult load(const facet::PacketStream& packets, const Progress& progress) override {
    packets_ = packets;
    return GoldenMachine::load(packets, progress);
  }

  void observe(const QueueObserver& observer) override { observer_ = observer; }

  VoxelMemory read_voxels() override {
    VoxelMemory voxels = GoldenMachine::read_voxels();
    if (fault_ == "voxel") voxels.erase(voxels.begin());
    if (fault_ == "owner") voxels.front().owner.facet ^= 1U;
    if (fault_ == "unknown owner") voxels.front().owner.facet = kMaxFacets - 1;
    return voxels;
  }

  LightResult light(const LightJob& job, const Progress& progress) override {
    if (observer_) show_queues(job);
    LightResult result = GoldenMachine::light(job, progress);
    if (fault_ == "slow") {
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));
      progress("light", 5000, 0.5);
    }
    if (fault_ == "target") --result.targets.escaped;
    return result;
  }

  LightMemory read_light() override {
    LightMemory light = GoldenMachine::read_light();
    if (fault_ == "voxel") {  // keeps the sum right: only the comparison can notice
      light[1] += light[0];
      light.erase(light.begin());
    }
    if (fault_ == "light") {
      ++light.front();
      --*std::find_if(light.begin() + 1, light.end(),
                      [](std::uint32_t count) { return count > 0; });
    }
    if (fault_ == "count") ++light.front();
    return light;
  }

 private:
  // Those of the cycle model, counted from a reset, one of them perhaps a beam too deep in one
  // cycle.
  void show_queues(const LightJob& job) {
    cycle::CycleMachine model(config());
    model.load(packets_, {});
    model.observe([&](std::int64_t cycle, std::vector<std::uint32_t> depths) {
      if (fault_ == "queue" && cycle == 9) ++depths[2 * 8 + 3];
      observer_(100 + cycle, depths);
    });
    model.light(job, {});
  }

  std::string fault_;
  facet::PacketStream packets_;
  QueueObserver observer_;
};

}  // namespace
}  // namespace rc2

extern "C" rc2::Machine* rc2_make_verilated_machine(const rc2::WaveWindow& waves) {
  const char* const named = std::getenv("RC2_TEST_FAULT");
  const std::string fault = named == nullptr ? "" : named;
  if (!waves.path.empty() && waves.from < 1000) std::ofstream(waves.path) << "waves";
  if (fault == "no memory") throw std::bad_alloc();
  rc2::MachineConfig config;
  config.n = 8;
  config.max_distance = 32;
  config.feeders = rc2::default_feeders(config.n);
  return std::make_unique<rc2::FaultyMachine>(config, fault).release();
}
