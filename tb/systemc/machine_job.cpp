#include "tb/systemc/machine_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "sw/machine/feeder.h"
#include "tb/systemc/dense_packets.h"

namespace rc2::tb {
namespace {

using namespace host_port;

// The array shows that it is busy a few cycles late; a command must not come in between.
constexpr int kBusyDelay = 8;
// A light of this machine takes some hundred cycles.
constexpr int kPollPause = 64;
constexpr int kMostPolls = 500;

const Progress kQuiet;

std::string describe_readback(const WordFormat& format, const Beat& beat) {
  if ((beat.low() >> kReadLastBit & 1U) != 0) return "end of the readback";
  const ReadbackWord word = unpack_readback(format, beat.low());
  const char* last = word.last_of_cell ? ", the cell's last" : "";
  if (word.empty) return fmt::format("an empty cell{}", last);
  return fmt::format("voxel z = {} holds {:#x}{}", word.z, word.value, last);
}

}  // namespace

MachineJob::MachineJob(std::uint64_t seed, std::int64_t jobs)
    : seed_(seed), jobs_(jobs), dice_(seed) {
  identify();
}

Scoreboard::Stream MachineJob::output(const StreamName& name) const {
  if (name.name == "readback") {
    return {name.name, [this](const Beat& beat) { return describe_readback(format_, beat); }};
  }
  if (name.name == "r") {
    return {name.name, [](const Beat& beat) {
              return fmt::format("register value {:#x}, response {}", beat.limbs[0], beat.limbs[1]);
            }};
  }
  return {name.name, [](const Beat& beat) { return fmt::format("response {}", beat.limbs[0]); }};
}

bool MachineJob::next(Bench& bench) {
  if (plan_.empty()) {
    if (done_ == jobs_) return false;
    plan_job();
    ++done_;
  }
  const Step step = std::move(plan_.front());
  plan_.pop_front();
  step(bench);
  return true;
}

void MachineJob::identify() {
  plan_.emplace_back([this](Bench& bench) {
    read(bench, kId, kMachineId);
    read(bench, kN, kMachine.n);
    read(bench, kF, kMachine.fraction_bits);
    read(bench, kLmax, kMachine.max_distance);
    read(bench, kFamax, kMachine.max_fa);
    read(bench, kPacketBits, static_cast<std::uint32_t>(format_.packet_bits()));
    read(bench, kReadbackBits, static_cast<std::uint32_t>(format_.readback_bits()));
    read(bench, kFacetNumberBits, kFacetBits);
    read(bench, kFeeders, kMachine.feeders);
    read(bench, kLayers, 1);
  });
}

void MachineJob::plan_job() {
  const auto coordinate = [this] { return static_cast<int>(dice_.roll(0, kMachine.n - 1)); };
  const glm::ivec2 cell(coordinate(), coordinate());
  packets_ = dense_packets(dice_, kMachine, 25, cell);
  golden_.load(packets_, kQuiet);

  plan_wait(0, false);
  plan_.emplace_back([](Bench& bench) {
    write(bench, kCommand, kCommandClear);
    bench.pause(kBusyDelay);
  });
  plan_.emplace_back([this](Bench& bench) { load(bench); });
  plan_wait(0, true);
  plan_read(ReadWhat::voxels);
  plan_read(ReadWhat::layers);
  for (int light = 0; light < 2; ++light) {
    if (const auto source = free_voxel()) plan_light(*source);
  }
}

void MachineJob::plan_light(glm::ivec3 source) {
  const LightJob job{source, static_cast<int>(dice_.roll(1, kMachine.max_distance)),
                     static_cast<int>(dice_.roll_size(kMachine.max_fa)),
                     dice_.one_in(2) ? LightRule::accurate : LightRule::thesis};
  const auto total = static_cast<std::uint32_t>(total_targets(job.target_distance));
  plan_wait(0, false);
  plan_.emplace_back([this, job, total](Bench& bench) {
    golden_.light(job, kQuiet);
    write(bench, kSourceX, static_cast<std::uint32_t>(job.source.x));
    write(bench, kSourceY, static_cast<std::uint32_t>(job.source.y));
    write(bench, kSourceZ, static_cast<std::uint32_t>(job.source.z));
    write(bench, kDistance, static_cast<std::uint32_t>(job.target_distance));
    write(bench, kFa, static_cast<std::uint32_t>(job.fa));
    write(bench, kTargets, total);
    write(bench, kInverse, inverse_of(job.target_distance, inverse_bits(kMachine)));
    const bool accurate = job.rule == LightRule::accurate;
    write(bench, kRule, accurate ? kRuleAccurate : 0);
    if (accurate) write(bench, kCommand, kCommandPrepare);
    bench.pause(kBusyDelay);
  });
  plan_wait(0, job.rule == LightRule::accurate);
  plan_.emplace_back([](Bench& bench) { write(bench, kCommand, kCommandStart); });
  plan_wait(kStatusHome, true);
  plan_.emplace_back([total](Bench& bench) { read(bench, kHome, total); });
  plan_read(ReadWhat::light);
  plan_read(ReadWhat::counters);
}

void MachineJob::plan_read(ReadWhat what) {
  plan_.emplace_back([this, what](Bench& bench) { ask(bench, what); });
}

void MachineJob::plan_wait(std::uint32_t status, bool note) {
  plan_.emplace_back([this, status](Bench& bench) { poll(bench, status, 0); });
  if (!note) return;
  plan_.emplace_back([](Bench& bench) { read_any(bench, kBusyCycles); });
  plan_.emplace_back([this](Bench& bench) { busy_cycles_.push_back(bench.last(kR).limbs[0]); });
}

// The reference cannot know how often the answer is "busy", but the last poll says what it waits
// for.
void MachineJob::poll(Bench& bench, std::uint32_t status, int polls) {
  if (polls == kMostPolls) {
    bench.expect(kR, {{}, Beat(status), Beat(status | kStatusBusy)});
    bench.send(kAr, Beat(kStatus));
    return;
  }
  read_any(bench, kStatus);
  plan_.push_front([this, status, polls](Bench& later) {
    if ((later.last(kR).limbs[0] & (status | kStatusBusy)) == status) return;
    later.pause(kPollPause);
    plan_.push_front([this, status, polls](Bench& again) { poll(again, status, polls + 1); });
  });
}

void MachineJob::load(Bench& bench) {
  // The same stalls from here on, however many cycles went before: two models that stand in the
  // same bench load in the same cycles.
  bench.reseed(seed_ * 1000 + static_cast<std::uint64_t>(done_));
  for (int k = 0; k < kMachine.feeders; ++k) {
    FeederWords words(packets_, k, kMachine.feeders);
    const std::size_t stream = kPackets + static_cast<std::size_t>(k);
    while (!words.done()) bench.send(stream, Beat(HostWord(format_, words.next())));
  }
  bench.pause(kBusyDelay);
}

void MachineJob::ask(Bench& bench, ReadWhat what) {
  const auto voxels = golden_.read_voxels();
  Readback counters(kMachine);
  for (glm::ivec3 at{0}; at.z < 2; ++at.z) {
    for (at.y = 0; at.y < kMachine.n; ++at.y) {
      for (at.x = 0; at.x < kMachine.n; ++at.x) counters.add(at, 0);
    }
  }
  const Readback expected =
      what == ReadWhat::voxels   ? readback_of(kMachine, voxels)
      : what == ReadWhat::layers ? readback_of(kMachine, golden_.read_layers())
      : what == ReadWhat::light  ? readback_of(kMachine, voxels, golden_.read_light())
                                 : counters;
  // How many beams a cell served and how deep its queue was is a matter of time; of an empty cell
  // only the two flags on top mean anything.
  const auto above = [](int bits) { return Beat(~std::uint64_t{0} << bits); };
  const Beat counted = what == ReadWhat::counters ? above(format_.value) : Expectation::all_bits();
  const Beat flags = above(format_.readback_bits() - 2);
  int cell = 0;
  for (const auto& beats : expected.beats()) {
    const glm::ivec2 at(cell % kMachine.n, cell / kMachine.n);
    for (const std::uint64_t beat : beats) {
      const bool empty = unpack_readback(format_, beat).empty;
      bench.expect(kReadback, {at, Beat(beat), empty ? flags : counted});
    }
    ++cell;
  }
  const Beat end(std::uint64_t{1} << kReadLastBit);
  bench.expect(kReadback, {glm::ivec2(kMachine.n - 1), end, end});
  for (std::size_t k = 0; k < kMachine.feeders; ++k) {
    bench.send(kPackets + k, Beat(HostWord(format_, what)));
  }
  bench.pause(kBusyDelay);
}

void MachineJob::write(Bench& bench, Register address, std::uint32_t value) {
  bench.send(kAw, Beat(address));
  bench.send(kW, Beat(value));
  bench.expect(kB, {{}, Beat(0)});
}

void MachineJob::read(Bench& bench, Register address, std::uint32_t expected) {
  bench.send(kAr, Beat(address));
  bench.expect(kR, {{}, Beat(expected)});
}

void MachineJob::read_any(Bench& bench, Register address) {
  bench.send(kAr, Beat(address));
  const Beat response(std::uint64_t{3} << kReadResponseBit);
  bench.expect(kR, {{}, Beat(0), response});
}

std::optional<glm::ivec3> MachineJob::free_voxel() {
  const VoxelMemory voxels = golden_.read_voxels();
  const auto coordinate = [this] { return static_cast<int>(dice_.roll(0, kMachine.n - 1)); };
  for (int attempt = 0; attempt < 200; ++attempt) {
    const glm::ivec3 at(coordinate(), coordinate(), coordinate());
    if (std::none_of(voxels.begin(), voxels.end(),
                     [&](const VoxelRecord& voxel) { return voxel.at == at; })) {
      return at;
    }
  }
  return std::nullopt;
}

}  // namespace rc2::tb
