#include "sw/tlm/host_port.h"

#include <fmt/format.h>

#include <limits>

#include "sw/machine/host_port.h"
#include "sw/machine/readback.h"
#include "sw/tlm/memory_map.h"

namespace rc2::tlm {

using namespace host_port;

namespace {

std::uint32_t low(std::int64_t value) { return static_cast<std::uint32_t>(value); }

}  // namespace

HostPort::HostPort(Machine& machine) : machine_(machine), format_(machine.config()) {
  const int distance = machine.config().max_distance;
  if (total_targets(distance) > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(
        fmt::format("a machine of L up to {} has more targets than a register of 32 bits "
                    "can count; build one of a smaller L",
                    distance));
  }
}

bool HostPort::is_register(std::uint64_t address) {
  return address % 4 == 0 && address <= kPrepareCycles;
}

bool HostPort::is_writable(std::uint64_t address) {
  return address == kCommand || address == kRule ||
         (address % 4 == 0 && address >= kSourceX && address <= kInverse);
}

std::uint32_t HostPort::read(std::uint64_t address) {
  const MachineConfig& config = machine_.config();
  const std::int64_t home =
      light_.targets.absorbed + light_.targets.escaped + light_.targets.skipped;
  if (address == kStatus || address == kBusyCycles) settle();
  switch (address) {
    case kId:
      return kMachineId;
    case kN:
      return low(config.n);
    case kF:
      return low(config.fraction_bits);
    case kLmax:
      return low(config.max_distance);
    case kFamax:
      return low(config.max_fa);
    case kPacketBits:
      return low(format_.packet_bits());
    case kReadbackBits:
      return low(format_.readback_bits());
    case kFacetNumberBits:
      return kFacetBits;
    case kFeeders:
      return 1;  // whatever the machine has: it is fed by its own side of the target
    case kLayers:
      return config.layers ? 1 : 0;
    case kStatus:
      return home == targets_ ? kStatusHome : 0;
    case kBusyCycles:
      return low(busy_cycles_);
    case kHomeCycle:
      return low(light_.home_cycles);
    case kHome:
      return low(home);
    case kSourceX:
      return source_x_;
    case kSourceY:
      return source_y_;
    case kSourceZ:
      return source_z_;
    case kDistance:
      return distance_;
    case kFa:
      return fa_;
    case kTargets:
      return targets_;
    case kGapAndNormal:
      return WordFormat::gap_and_normal(config.n);
    case kInverse:
      return inverse_;
    case kBuild:
      return build_flags(config);
    case kInverseBits:
      return low(inverse_bits(config));
    case kSkipped:
      return low(light_.targets.skipped);
    case kRule:
      return rule_;
    case kWaiting:
      return low(static_cast<std::int64_t>(waiting()));
    case kVisitsLow:
      return low(light_.visits);
    case kVisitsHigh:
      return low(light_.visits >> 32);
    case kDeepestQueue:
      return low(light_.max_queue);
    case kAbsorbed:
      return low(light_.targets.absorbed);
    case kPrepareCycles:
      return low(light_.prepare_cycles);
    default:
      return 0;
  }
}

void HostPort::write(std::uint64_t address, std::uint32_t value) {
  switch (address) {
    case kSourceX:
      source_x_ = value;
      break;
    case kSourceY:
      source_y_ = value;
      break;
    case kSourceZ:
      source_z_ = value;
      break;
    case kDistance:
      distance_ = value;
      break;
    case kFa:
      fa_ = value;
      break;
    case kTargets:
      targets_ = value;
      break;
    case kInverse:
      inverse_ = value;
      break;
    case kRule:
      rule_ = value & kRuleAccurate;
      break;
    case kCommand:
      // Where a light stops the model looks up when it starts.
      if ((value & kCommandPrepare) != 0) busy_cycles_ = 0;
      if ((value & kCommandClear) != 0) {
        reader_ = {};
        loaded_ = false;
        busy_cycles_ = 0;
      }
      if ((value & kCommandStart) != 0) start();
      break;
    default:
      break;
  }
}

void HostPort::push(const HostWord::Limbs& limbs) {
  const Word word = unpack_word(format_, limbs);
  if (word.kind == WordKind::read) {
    answer(static_cast<ReadWhat>(word.d & 7));
  } else {
    reader_.read(word);
    loaded_ = false;
  }
}

std::uint64_t HostPort::pop() {
  const std::uint64_t beat = readback_.front();
  readback_.pop_front();
  return beat;
}

std::int64_t HostPort::take_cycles() {
  const std::int64_t cycles = cycles_;
  cycles_ = 0;
  return cycles;
}

void HostPort::settle() {
  if (loaded_) return;
  busy_cycles_ = machine_.load(reader_.packets(), {}).cycles;
  cycles_ += busy_cycles_;
  loaded_ = true;
  light_ = {};
}

LightJob HostPort::job() const {
  // A number that no coordinate can be stays out of range when it becomes signed.
  const auto number = [](std::uint32_t value) {
    constexpr std::uint32_t kTooLarge = 1U << 30;
    return static_cast<int>(std::min(value, kTooLarge));
  };
  return {{number(source_x_), number(source_y_), number(source_z_)},
          number(distance_),
          number(fa_),
          rule_ != 0 ? LightRule::accurate : LightRule::thesis};
}

void HostPort::start() {
  settle();
  light_ = machine_.light(job(), {});
  busy_cycles_ = light_.cycles;
  cycles_ += light_.prepare_cycles + busy_cycles_;
}

void HostPort::answer(ReadWhat what) {
  settle();
  const MachineConfig& config = machine_.config();
  if (what == ReadWhat::counters || what == ReadWhat::ends) {
    throw Error(
        fmt::format("the counters of single cells are not part of the model; read the registers "
                    "{:02X}, {:02X}, "
                    "{:02X} and {:02X}, which sum them up",
                    static_cast<int>(kVisitsLow), static_cast<int>(kVisitsHigh),
                    static_cast<int>(kDeepestQueue), static_cast<int>(kAbsorbed)));
  }
  const Readback readback = what == ReadWhat::voxels   ? readback_of(config, machine_.read_voxels())
                            : what == ReadWhat::layers ? readback_of(config, machine_.read_layers())
                                                       : readback_of(config, machine_.read_voxels(),
                                                                     machine_.read_light());
  for (const auto& cell : readback.beats()) {
    readback_.insert(readback_.end(), cell.begin(), cell.end());
  }
  readback_.push_back(kReadbackEnd);
}

}  // namespace rc2::tlm
