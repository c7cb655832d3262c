// The cycle model behind the pins of the host port: the registers as rtl/rc2_machine.sv has them,
// loading clock for clock, a light as long as the model says. The model has no readback of its own;
// here it is a list of beats.
#include <deque>
#include <optional>

#include "sw/cycle/lane_array.h"
#include "sw/cycle/load_array.h"
#include "sw/cycle/prepare.h"
#include "sw/machine/host_port.h"
#include "tb/systemc/cycle_answer.h"
#include "tb/systemc/machine_unit.h"

namespace rc2::tb {
namespace {

using namespace host_port;

class CycleMachineUnit final : public Unit {
 public:
  const StreamNames& names() const override { return names_; }

  void settle(UnitPins& pins) override {
    const bool write = pins.in[kAw].valid && pins.in[kW].valid && !response_;
    pins.in[kAw].ready = pins.in[kW].ready = write;
    pins.in[kAr].ready = pins.in[kAr].valid && !answer_;
    for (std::size_t k = 0; k < kStreams; ++k) {
      pins.in[kPackets + k].ready = load_.ready(k) && !asked_[k];
    }
    pins.out[kB].valid = response_;
    pins.out[kR].valid = answer_.has_value();
    if (answer_) pins.out[kR].beat = Beat(*answer_);
    pins.out[kReadback].valid = !readback_.empty();
    if (!readback_.empty()) pins.out[kReadback].beat = Beat(readback_.front());
  }

  void clock(const UnitPins& pins) override {
    const auto moves = [](const Pins& stream) { return stream.valid && stream.ready; };
    const bool write = moves(pins.in[kAw]), read = moves(pins.in[kAr]);
    // All that is read is what the registers held before the edge.
    const std::uint32_t value = read ? read_register(pins.in[kAr].beat.limbs[0]) : 0;
    if (moves(pins.out[kB])) response_ = false;
    if (moves(pins.out[kR])) answer_.reset();
    if (moves(pins.out[kReadback])) readback_.pop_front();
    if (read) answer_ = value;

    count_busy();
    obey();
    for (std::size_t k = 0; k < kStreams; ++k) {
      words_[k].reset();
      if (!moves(pins.in[kPackets + k])) continue;
      const Word word = unpack_word(format_, pins.in[kPackets + k].beat.limbs);
      if (word.kind == WordKind::read) {
        asked_[k] = static_cast<ReadWhat>(word.d);
      } else {
        words_[k] = word;
      }
    }
    load_.step(words_);
    answer_reads();
    if (write) {
      response_ = true;
      write_register(pins.in[kAw].beat.limbs[0], pins.in[kW].beat.limbs[0]);
    }
  }

 private:
  static constexpr std::size_t kStreams = kMachine.feeders;

  bool works() const {
    return load_.busy() || prepare_left_ > 0 || light_left_ > 0 || !readback_.empty();
  }

  // The array says that it is busy two cycles late (rtl/rc2_array.sv).
  void count_busy() {
    if (busy_[1]) ++busy_cycles_;
    busy_ = {works(), busy_[0]};
    if (light_left_ > 0) --light_left_;
    if (prepare_left_ > 0) --prepare_left_;
  }

  // A command is obeyed in the cycle after it was written.
  void obey() {
    if (command_ != 0) busy_cycles_ = 0;
    if ((command_ & kCommandClear) != 0) columns_.clear();
    if ((command_ & kCommandPrepare) != 0) {
      columns_.darken();
      prepare_left_ = cycle::prepare(light_job(), kMachine.n, columns_);
    }
    if ((command_ & kCommandStart) != 0) {
      light_.settle();
      light_result_ = light_.run(light_job(), {}, {});
      light_left_ = light_result_.cycles;
    }
    command_ = 0;
  }

  LightJob light_job() const {
    const auto at = [&](Register axis) { return static_cast<int>(registers_[axis]); };
    return {{at(kSourceX), at(kSourceY), at(kSourceZ)},
            at(kDistance),
            at(kFa),
            registers_[kRule] == kRuleAccurate ? LightRule::accurate : LightRule::thesis};
  }

  void write_register(std::uint32_t address, std::uint32_t value) {
    if (address == kCommand) command_ = value;
    if ((address >= kSourceX && address <= kInverse) || address == kRule)
      registers_[address] = value;
  }

  std::uint32_t read_register(std::uint32_t address) const {
    const TargetCount& targets = light_result_.targets;
    const std::int64_t home = targets.absorbed + targets.escaped + targets.skipped;
    switch (address) {
      case kId:
        return kMachineId;
      case kN:
        return kMachine.n;
      case kF:
        return kMachine.fraction_bits;
      case kLmax:
        return kMachine.max_distance;
      case kFamax:
        return kMachine.max_fa;
      case kPacketBits:
        return static_cast<std::uint32_t>(format_.packet_bits());
      case kReadbackBits:
        return static_cast<std::uint32_t>(format_.readback_bits());
      case kFacetNumberBits:
        return kFacetBits;
      case kFeeders:
        return kMachine.feeders;
      case kLayers:
        return 1;
      case kStatus:
        return (busy_[1] ? kStatusBusy : 0) |
               (light_left_ == 0 && home == registers_[kTargets] ? kStatusHome : 0);
      case kBusyCycles:
        return static_cast<std::uint32_t>(busy_cycles_);
      case kHomeCycle:
        return static_cast<std::uint32_t>(light_result_.home_cycles);
      case kHome:
        return light_left_ == 0 ? static_cast<std::uint32_t>(home) : 0;
      case kSkipped:
        return light_left_ == 0 ? static_cast<std::uint32_t>(targets.skipped) : 0;
      default:
        return registers_[address];
    }
  }

  // A READ waits until all that came before it is done.
  void answer_reads() {
    for (const auto& asked : asked_) {
      if (!asked) return;
    }
    if (load_.busy()) return;
    const ReadWhat what = *asked_[0];
    Readback readback(kMachine);
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      answer(columns_, kMachine.n, column, what, readback);
      if (what != ReadWhat::counters) continue;
      const auto cell = static_cast<int>(column);
      const glm::ivec2 at(cell % kMachine.n, cell / kMachine.n);
      readback.add({at, 0}, 0);  // the model does not count cell by cell
      readback.add({at, 1}, 0);
    }
    for (const auto& cell : readback.beats()) {
      readback_.insert(readback_.end(), cell.begin(), cell.end());
    }
    readback_.push_back(std::uint64_t{1} << kReadLastBit);
    asked_.fill({});
  }

  StreamNames names_ = machine_streams();
  WordFormat format_{kMachine};
  cycle::Columns columns_{kMachine.n};
  cycle::LoadArray load_{kMachine.n, kMachine.feeders, columns_};
  cycle::LaneArray light_{kMachine.n, kMachine.skips, columns_};
  LightResult light_result_;
  std::int64_t prepare_left_ = 0, light_left_ = 0;  // cycles

  std::array<std::uint32_t, 128> registers_{};  // by address
  std::uint32_t command_ = 0;
  bool response_ = false;
  std::optional<std::uint32_t> answer_;
  std::array<bool, 2> busy_{};
  std::int64_t busy_cycles_ = 0;

  std::vector<std::optional<Word>> words_{kStreams};
  std::array<std::optional<ReadWhat>, kStreams> asked_;
  std::deque<std::uint64_t> readback_;
};

}  // namespace

std::unique_ptr<Unit> make_cycle_machine() { return std::make_unique<CycleMachineUnit>(); }

}  // namespace rc2::tb
