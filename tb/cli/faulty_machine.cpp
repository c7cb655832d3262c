// Stands in for a Verilated library: the cycle model with the fault that the environment names.
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

namespace rc2 {
namespace {

class FaultyMachine : public cycle::CycleMachine {
 public:
  FaultyMachine(const MachineConfig& config, std::string fault)
      : CycleMachine(config), fault_(std::move(fault)) {}

  // Counts from a reset; one queue is perhaps a beam too deep in one cycle.
  void observe(const QueueObserver& observer) override {
    CycleMachine::observe([this, observer](std::int64_t cycle, std::vector<std::uint32_t> depths) {
      if (fault_ == "queue" && cycle == 9) ++depths[2 * 8 + 3];
      observer(100 + cycle, depths);
    });
  }

  VoxelMemory read_voxels() override {
    VoxelMemory voxels = CycleMachine::read_voxels();
    if (fault_ == "voxel") voxels.erase(voxels.begin());
    if (fault_ == "owner") voxels.front().owner.facet ^= 1U;
    if (fault_ == "unknown owner") voxels.front().owner.facet = kMaxFacets - 1;
    return voxels;
  }

  LightResult light(const LightJob& job, const Progress& progress) override {
    LightResult result = CycleMachine::light(job, progress);
    if (fault_ == "slow") {
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));
      progress("light", 5000, 0.5);
    }
    if (fault_ == "late") ++result.cycles;
    if (fault_ == "target") --result.targets.escaped;
    return result;
  }

  LightMemory read_light() override {
    LightMemory light = CycleMachine::read_light();
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
  std::string fault_;
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
