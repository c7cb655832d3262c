#include "sim/platform/host.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "sim/platform/bus.h"
#include "sw/machine/feeder.h"
#include "sw/machine/host_port.h"
#include "sw/machine/readback.h"
#include "sw/tlm/memory_map.h"

namespace rc2 {
namespace {

using namespace host_port;

// The software's buffer in the platform's memory: as much as goes through a window at once.
constexpr std::uint64_t kBuffer = Bus::kMemory.start;

// One batch for each packet: they are sent as they come, and the machine behind the target spreads
// them over its feeders by itself.
facet::PacketStream one_by_one(const facet::PacketStream& packets) {
  facet::PacketStream stream{packets.heads, packets.sides, {}};
  const auto all = static_cast<std::uint32_t>(packets.heads.size());
  auto batches = packets.batches;
  if (batches.empty()) batches.push_back({0, all, false});
  for (const facet::Batch& batch : batches) {
    for (std::uint32_t i = 0; i < batch.count; ++i) {
      stream.batches.push_back({batch.first + i, 1, false});
    }
    if (batch.ends_object) stream.batches.push_back({batch.first + batch.count, 0, true});
  }
  return stream;
}

}  // namespace

Host::Host(const sc_core::sc_module_name& name, Software software, Why why)
    : sc_module(name), socket("socket"), software_(std::move(software)), why_(std::move(why)) {
  SC_THREAD(run);
  set_stack_size(1 << 24);  // the machine behind the target works on this stack
}

void Host::run() {
  time_.reset();
  try {
    identify();
    software_(*this);
  } catch (...) {
    failure_ = std::current_exception();
  }
  time_.sync();
  sc_core::sc_stop();
}

void Host::identify() {
  if (read_register(kId) != kMachineId) throw std::logic_error("not an RC2 machine");
  config_.n = static_cast<int>(read_register(kN));
  config_.fraction_bits = static_cast<int>(read_register(kF));
  config_.max_distance = static_cast<int>(read_register(kLmax));
  config_.max_fa = static_cast<int>(read_register(kFamax));
  config_.feeders = static_cast<int>(read_register(kFeeders));
  config_.layers = read_register(kLayers) != 0;
  format_.emplace(config_);
}

LoadResult Host::load(const facet::PacketStream& packets, const Progress& /*progress*/) {
  write_register(kCommand, kCommandClear);
  const facet::PacketStream ordered = one_by_one(packets);
  std::vector<HostWord::Limbs> words;
  for (FeederWords feeder(ordered, 0, 1); !feeder.done();) {
    words.push_back(HostWord(*format_, feeder.next()).limbs());
  }
  send_words(words);
  while ((read_register(kStatus) & kStatusBusy) != 0) {
  }
  return {read_register(kBusyCycles)};
}

LightResult Host::light(const LightJob& job, const Progress& /*progress*/) {
  LightResult result;
  result.targets.total = total_targets(job.target_distance);
  write_register(kSourceX, static_cast<std::uint32_t>(job.source.x));
  write_register(kSourceY, static_cast<std::uint32_t>(job.source.y));
  write_register(kSourceZ, static_cast<std::uint32_t>(job.source.z));
  write_register(kDistance, static_cast<std::uint32_t>(job.target_distance));
  write_register(kFa, static_cast<std::uint32_t>(job.fa));
  write_register(kTargets, static_cast<std::uint32_t>(result.targets.total));
  write_register(kInverse,
                 inverse_of(job.target_distance, static_cast<int>(read_register(kInverseBits))));
  const bool accurate = job.rule == LightRule::accurate;
  write_register(kRule, accurate ? kRuleAccurate : 0);
  if (accurate) write_register(kCommand, kCommandPrepare);
  write_register(kCommand, kCommandStart);
  while ((read_register(kStatus) & (kStatusBusy | kStatusHome)) != kStatusHome) {
  }
  result.cycles = read_register(kBusyCycles);
  result.home_cycles = read_register(kHomeCycle);
  result.visits = static_cast<std::int64_t>(read_register(tlm::kVisitsHigh)) << 32 |
                  read_register(tlm::kVisitsLow);
  result.max_queue = read_register(tlm::kDeepestQueue);
  result.prepare_cycles = read_register(tlm::kPrepareCycles);
  result.targets.absorbed = read_register(tlm::kAbsorbed);
  result.targets.skipped = read_register(kSkipped);
  result.targets.escaped = read_register(kHome) - result.targets.absorbed - result.targets.skipped;
  return result;
}

VoxelMemory Host::read_voxels() {
  VoxelMemory voxels;
  for (const Reading& reading : ask(ReadWhat::voxels)) {
    voxels.push_back({reading.at, Claim::unpacked(reading.value)});
  }
  return voxels;
}

LayerMemory Host::read_layers() {
  LayerMemory memory;
  for (const Reading& reading : ask(ReadWhat::layers)) {
    memory.push_back(unpacked_layers(reading.at, reading.value));
  }
  return memory;
}

LightMemory Host::read_light() {
  LightMemory light;
  for (const Reading& reading : ask(ReadWhat::light)) light.push_back(reading.value);
  return light;
}

std::vector<Host::Reading> Host::ask(ReadWhat what) {
  send_words({HostWord(*format_, what).limbs()});
  std::vector<Reading> readings;
  int cell = 0;
  for (const std::uint64_t beat : fetch_readback()) {
    const ReadbackWord word = unpack_readback(*format_, beat);
    if (!word.empty) readings.push_back({{cell % config_.n, cell / config_.n, word.z}, word.value});
    if (word.last_of_cell) ++cell;
  }
  std::sort(readings.begin(), readings.end(), [](const Reading& a, const Reading& b) {
    return std::tie(a.at.z, a.at.y, a.at.x) < std::tie(b.at.z, b.at.y, b.at.x);
  });
  return readings;
}

void Host::send_words(const std::vector<HostWord::Limbs>& words) {
  constexpr std::size_t kAtOnce = tlm::kPacketsSize / tlm::kPacketBytes;
  for (std::size_t first = 0; first < words.size(); first += kAtOnce) {
    std::vector<HostWord::Limbs> page(
        words.begin() + static_cast<std::ptrdiff_t>(first),
        words.begin() + static_cast<std::ptrdiff_t>(std::min(first + kAtOnce, words.size())));
    const std::size_t bytes = page.size() * tlm::kPacketBytes;
    transfer(::tlm::TLM_WRITE_COMMAND, kBuffer, page.data(), bytes);
    transfer(::tlm::TLM_READ_COMMAND, kBuffer, page.data(), bytes);
    transfer(::tlm::TLM_WRITE_COMMAND, Bus::kMachine.start + tlm::kPackets, page.data(), bytes);
  }
}

// Without the beat that ends it.
std::vector<std::uint64_t> Host::fetch_readback() {
  constexpr std::size_t kAtOnce = tlm::kReadbackSize / tlm::kReadbackBytes;
  std::vector<std::uint64_t> beats;
  for (std::size_t left = read_register(tlm::kWaiting); left > 0;) {
    std::vector<std::uint64_t> page(std::min(left, kAtOnce));
    const std::size_t bytes = page.size() * tlm::kReadbackBytes;
    transfer(::tlm::TLM_READ_COMMAND, Bus::kMachine.start + tlm::kReadback, page.data(), bytes);
    transfer(::tlm::TLM_WRITE_COMMAND, kBuffer, page.data(), bytes);
    transfer(::tlm::TLM_READ_COMMAND, kBuffer, page.data(), bytes);
    beats.insert(beats.end(), page.begin(), page.end());
    left -= page.size();
  }
  if (beats.empty() || beats.back() != tlm::kReadbackEnd) {
    throw std::logic_error("the readback has no end");
  }
  beats.pop_back();
  return beats;
}

std::uint32_t Host::read_register(unsigned address) {
  std::uint32_t value = 0;
  transfer(::tlm::TLM_READ_COMMAND, Bus::kMachine.start + address, &value, sizeof value);
  return value;
}

void Host::write_register(unsigned address, std::uint32_t value) {
  transfer(::tlm::TLM_WRITE_COMMAND, Bus::kMachine.start + address, &value, sizeof value);
}

void Host::transfer(::tlm::tlm_command command, std::uint64_t address, void* data,
                    std::size_t bytes) {
  ::tlm::tlm_generic_payload transaction;
  transaction.set_command(command);
  transaction.set_address(address);
  transaction.set_data_ptr(static_cast<unsigned char*>(data));
  transaction.set_data_length(static_cast<unsigned>(bytes));
  transaction.set_streaming_width(static_cast<unsigned>(bytes));
  sc_core::sc_time delay = time_.get_local_time();
  socket->b_transport(transaction, delay);
  ++transactions_;
  time_.set(delay);
  if (time_.need_sync()) time_.sync();
  if (transaction.is_response_error()) {
    throw Error(fmt::format("the platform's transaction at {:#x} failed ({}): {}", address,
                            transaction.get_response_string(), why_()));
  }
}

}  // namespace rc2
