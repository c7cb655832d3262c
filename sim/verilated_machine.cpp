// The Machine interface on top of the Verilated array: the only code that touches its pins.
// Compiled once per n into librc2_rtl_n<N>.so together with what Verilator wrote.
#include <fmt/format.h>
#include <verilated.h>
#include <verilated_fst_c.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "Vrc2_machine.h"
#include "sim/coverage.h"
#include "sim/queue_watch.h"
#include "sim/rtl_machine.h"
#include "sim/wave_list.h"
#include "sw/machine/checks.h"
#include "sw/machine/feeder.h"
#include "sw/machine/host_port.h"
#include "sw/machine/host_word.h"
#include "sw/machine/queue_history.h"
#include "sw/machine/ray_words.h"
#include "sw/machine/readback.h"

namespace rc2 {
namespace {

using namespace host_port;

// The array reports itself busy a few cycles late (rc2_array); nothing starts within that time.
constexpr int kBusyDelay = 8;
// Cycles in which nothing comes that the host waits for, after which the array is taken to block.
constexpr std::int64_t kPatience = 1'000'000;

// Puts a word into the pins of its feeder, which begin at byte `at`; the bytes are little-endian.
template <typename Pins>
void set_pins(Pins& pins, std::size_t at, const HostWord& word, std::size_t bytes) {
  std::memcpy(reinterpret_cast<unsigned char*>(&pins) + at, word.limbs().data(), bytes);
}

/// A value that a cell holds for one of its voxels, or a counter.
struct Reading {
  glm::ivec3 at;
  std::uint32_t value;
};

class VerilatedMachine final : public Machine {
 public:
  explicit VerilatedMachine(const WaveWindow& waves)
      : top_(&context_, "rc2"), waves_(waves), config_(reset_and_identify()), format_(config_) {
    if (read_register(kPacketBits) != static_cast<std::uint32_t>(format_.packet_bits()) ||
        read_register(kReadbackBits) != static_cast<std::uint32_t>(format_.readback_bits()) ||
        read_register(kFacetNumberBits) != kFacetBits ||
        read_register(kGapAndNormal) != WordFormat::gap_and_normal(config_.n)) {
      throw std::logic_error("rtl/rc2_pkg.sv and sw/machine/host_word.h disagree about a word");
    }
  }

  ~VerilatedMachine() override {
    if (tracing_) trace_.close();
    top_.final();
    hand_in_coverage(context_);
  }
  VerilatedMachine(const VerilatedMachine&) = delete;
  VerilatedMachine& operator=(const VerilatedMachine&) = delete;

  const MachineConfig& config() const override { return config_; }

  LoadResult load(const facet::PacketStream& packets, const Progress& progress) override {
    check_packets(config_, packets);
    write_register(kCommand, kCommandClear);
    std::vector<FeederWords> feeders;
    for (int k = 0; k < config_.feeders; ++k) feeders.emplace_back(packets, k, config_.feeders);
    std::int64_t sent = 0;
    send([&](std::size_t k, HostWord& word) {
      if (feeders[k].done()) return false;
      word = HostWord(format_, feeders[k].next());
      if (++sent % 256 == 0 && progress) progress("load", cycle_, feeders[0].share());
      return true;
    });
    wait_until_idle();
    const LoadResult result{read_register(kBusyCycles)};
    voxels_.clear();
    for (const Reading& reading : read_back(ReadWhat::voxels)) {
      voxels_.push_back({reading.at, Claim::unpacked(reading.value)});
    }
    light_.assign(voxels_.size(), 0);
    boxes_ = boxes_of(packets);
    return result;
  }

  LightResult light(const LightJob& job, const Progress& progress) override {
    check_light(config_, job);
    write_register(kSourceX, static_cast<std::uint32_t>(job.source.x));
    write_register(kSourceY, static_cast<std::uint32_t>(job.source.y));
    write_register(kSourceZ, static_cast<std::uint32_t>(job.source.z));
    write_register(kDistance, static_cast<std::uint32_t>(job.target_distance));
    write_register(kFa, static_cast<std::uint32_t>(job.fa));
    write_register(kInverse,
                   inverse_of(job.target_distance, static_cast<int>(read_register(kInverseBits))));
    LightResult result;
    result.targets.total = total_targets(job.target_distance);
    write_register(kTargets, static_cast<std::uint32_t>(result.targets.total));
    write_register(kRule, job.rule == LightRule::accurate ? kRuleAccurate : 0);
    if (!waves_.path.empty() && !waves_listed_) {
      write_wave_list(waves_.path, config_, job.source, cycle_, waves_.cell);
      waves_listed_ = true;
    }
    if (job.rule == LightRule::accurate) {
      write_register(kCommand, kCommandPrepare);
      wait_until_idle();
      result.prepare_cycles = read_register(kBusyCycles);
    }
    lighting_ = true;
    write_register(kCommand, kCommandStart);

    std::int64_t home = 0;
    std::int64_t home_since = cycle_;
    do {
      step(64);
      const std::int64_t now = read_register(kHome);
      if (now != home) home_since = cycle_;
      home = now;
      lose_patience(home_since,
                    fmt::format("{} of {} targets came home", home, result.targets.total));
      if (progress) {
        progress("light", read_register(kBusyCycles),
                 static_cast<double>(home) / static_cast<double>(result.targets.total));
      }
    } while ((read_register(kStatus) & kStatusBusy) != 0);
    lighting_ = false;
    step(2 * config_.n + kBusyDelay);  // the last targets' way home
    result.cycles = read_register(kBusyCycles);
    result.home_cycles = read_register(kHomeCycle);
    const bool all_home = (read_register(kStatus) & kStatusHome) != 0;
    home = read_register(kHome);

    const auto counts = read_back(ReadWhat::light);
    light_.clear();
    for (const auto& record : counts) {
      light_.push_back(record.value);
      if (config_.mode == LightMode::thesis) result.targets.absorbed += record.value;
    }
    // Light in lanes goes on through voxels that it lights.
    if (config_.counts && config_.mode == LightMode::fast)
      for (const auto& cell : read_back(ReadWhat::ends)) result.targets.absorbed += cell.value;
    result.targets.skipped = read_register(kSkipped);
    result.targets.escaped = home - result.targets.absorbed - result.targets.skipped;
    if (config_.counts && !all_home) {
      throw std::logic_error(fmt::format("conservation is broken: {} of {} targets came home", home,
                                         result.targets.total));
    }
    // Of each cell its visits and, above the deepest queue, the signature of all its queues.
    const int depth_bits = queue_bits(config_.max_fa);
    QueueHistory history(static_cast<std::size_t>(config_.n) * static_cast<std::size_t>(config_.n));
    for (const auto& [at, value] : read_back(ReadWhat::counters)) {
      if (at.z == 0) {
        result.visits += value;
      } else {
        const std::uint32_t deepest = value & ((1U << depth_bits) - 1);
        result.max_queue = std::max<std::int64_t>(result.max_queue, deepest);
        history.set(static_cast<std::size_t>(at.y * config_.n + at.x),
                    static_cast<std::uint16_t>(value >> depth_bits));
      }
    }
    result.queue_history = history.signature();
    return result;
  }

  RayResult trace(const RayJob& job, const Progress& progress) override {
    check_rays(config_, job, voxels_);
    if (config_.ray_depth == 0)
      throw Error(
          "this Verilated machine has no cells for rays; build one that has, or use --machine "
          "golden or cycle");
    if (job.limits.depth > config_.ray_depth || job.queue > config_.ray_queue)
      throw Error(
          fmt::format("the rays cannot be traced: depth {} and queues of {} places, where the "
                      "Verilated machine "
                      "was built for {} and {}; ask for less, or raise RC2_RAYDEPTH and RC2_RAYQ",
                      job.limits.depth, job.queue, config_.ray_depth, config_.ray_queue));
    write_register(kCommand, kCommandClearRays);
    write_register(kRayLimits, ray_limits(job.limits.depth, job.queue, job.limits.least_weight));
    send_rays(job);
    wait_until_idle();
    RayResult result;
    result.traffic.load_cycles = read_register(kBusyCycles);
    write_register(kCommand, kCommandTrace);
    // One ray after another could not take longer.
    const std::int64_t longest = (std::int64_t{config_.n} * config_.n << (job.limits.depth + 1)) *
                                 (3 * config_.n * (config_.n + 3) + 1000);
    const std::int64_t start = cycle_;
    step(kBusyDelay);
    while ((read_register(kStatus) & kStatusBusy) != 0) {
      step(64);
      lose_patience(start, "rays do not end", longest);
      if (progress) progress("rays", cycle_ - start, 0.5);
    }
    result.traffic.cycles = read_register(kBusyCycles);
    read_hits(result);
    return result;
  }

  void observe(const QueueObserver& observer) override {
    observer_ = observer;
    if (!queues_) queues_.emplace(context_, config_);
  }

  VoxelMemory read_voxels() override { return voxels_; }
  LightMemory read_light() override { return light_; }

  LayerMemory read_layers() override {
    LayerMemory memory;
    for (const Reading& reading : read_back(ReadWhat::layers)) {
      memory.push_back(unpacked_layers(reading.at, reading.value));
    }
    return memory;
  }

 private:
  // ---- Clock -------------------------------------------------------------------------------
  void half(bool high) {
    top_.clk_i = high ? 1 : 0;
    top_.eval();
    if (tracing_)
      trace_.dump(static_cast<std::uint64_t>(cycle_ * kWaveTimePerCycle +
                                             (high ? 0 : kWaveTimePerCycle / 2)));
  }

  /// One clock cycle. Inputs set before are seen by its rising edge; outputs read after are what
  /// the registers hold then.
  void tick() {
    if (!waves_.path.empty() && cycle_ == waves_.from) open_waves();
    half(true);
    half(false);
    ++cycle_;
    if (observer_ && lighting_) observer_(cycle_, queues_->depths());
    if (tracing_ && cycle_ == waves_.from + waves_.cycles) {
      trace_.close();
      tracing_ = false;
    }
  }

  void step(int cycles) {
    for (int i = 0; i < cycles; ++i) tick();
  }

  void open_waves() {
    context_.traceEverOn(true);
    top_.trace(&trace_, 99);
    trace_.open(waves_.path.c_str());
    if (!trace_.isOpen()) {
      throw Error(waves_.path +
                  ": the waveform cannot be written; name a file in a folder that exists");
    }
    tracing_ = true;
  }

  MachineConfig reset_and_identify() {
    if (!waves_.path.empty()) context_.traceEverOn(true);
    top_.rst_ni = 0;
    step(2);
    top_.rst_ni = 1;
    step(1);
    if (read_register(kId) != kMachineId) throw std::logic_error("not an RC2 machine");
    MachineConfig config;
    config.n = static_cast<int>(read_register(kN));
    config.fraction_bits = static_cast<int>(read_register(kF));
    config.max_distance = static_cast<int>(read_register(kLmax));
    config.max_fa = static_cast<int>(read_register(kFamax));
    config.feeders = static_cast<int>(read_register(kFeeders));
    config.layers = read_register(kLayers) != 0;
    const std::uint32_t build = read_register(kBuild);
    config.mode = (build & kBuildThesis) != 0 ? LightMode::thesis : LightMode::fast;
    config.counts = (build & kBuildCounts) != 0;
    config.skips = (build & kBuildSkips) != 0;
    const std::uint32_t rays = read_register(kRays);
    config.ray_depth = static_cast<int>(rays & 0xFF);
    config.ray_queue = static_cast<int>(rays >> 8);
    if (read_register(kInverseBits) > 32) {
      throw std::logic_error("rtl/rc2_machine.sv: 1/L does not fit its register");
    }
    return config;
  }

  // ---- AXI4-Lite ---------------------------------------------------------------------------
  void write_register(Register address, std::uint32_t value) {
    top_.s_axil_awvalid = 1;
    top_.s_axil_awaddr = address;
    top_.s_axil_wvalid = 1;
    top_.s_axil_wdata = value;
    tick();  // an idle slave takes both at once
    top_.s_axil_awvalid = 0;
    top_.s_axil_wvalid = 0;
    top_.s_axil_bready = 1;
    tick();
    top_.s_axil_bready = 0;
    if (address == kCommand) step(kBusyDelay);
  }

  std::uint32_t read_register(Register address) {
    top_.s_axil_arvalid = 1;
    top_.s_axil_araddr = address;
    tick();
    top_.s_axil_arvalid = 0;
    const std::uint32_t value = top_.s_axil_rdata;
    top_.s_axil_rready = 1;
    tick();
    top_.s_axil_rready = 0;
    return value;
  }

  void wait_until_idle() {
    const std::int64_t since = cycle_;
    step(kBusyDelay);
    while ((read_register(kStatus) & kStatusBusy) != 0) lose_patience(since, "it stays busy");
  }

  void lose_patience(std::int64_t since, std::string_view what,
                     std::int64_t cycles = kPatience) const {
    if (cycle_ - since > cycles)
      throw std::logic_error(fmt::format("rtl/rc2_machine.sv: the array blocks: {}", what));
  }

  // ---- AXI4-Stream -------------------------------------------------------------------------
  /// Sends to every feeder what next(feeder, word) gives, until it gives no more.
  template <typename Next>
  void send(Next next) {
    const auto feeders = static_cast<std::size_t>(config_.feeders);
    const auto bytes = static_cast<std::size_t>(format_.packet_bits() + 7) / 8;
    HostWord word(format_, ReadWhat::voxels);
    std::uint64_t valid = 0;
    const auto offer = [&](std::size_t k) {
      if (!next(k, word)) return;
      set_pins(top_.s_axis_tdata, k * bytes, word, bytes);
      valid |= std::uint64_t{1} << k;
    };
    for (std::size_t k = 0; k < feeders; ++k) offer(k);
    std::int64_t since = cycle_;
    while (valid != 0) {
      top_.s_axis_tvalid =
          static_cast<std::remove_reference_t<decltype(top_.s_axis_tvalid)>>(valid);
      const std::uint64_t taken = valid & top_.s_axis_tready;
      tick();
      if (taken != 0) since = cycle_;
      lose_patience(since, "it takes no word");
      valid &= ~taken;
      for (std::size_t k = 0; k < feeders; ++k) {
        if ((taken >> k & 1U) != 0) offer(k);
      }
    }
    top_.s_axis_tvalid = 0;
  }

  /// Asks every cell for its words. Sorted by z, y, x.
  std::vector<Reading> read_back(ReadWhat what) {
    std::vector<Reading> records = read_words(what);
    std::sort(records.begin(), records.end(), [](const Reading& a, const Reading& b) {
      return std::tie(a.at.z, a.at.y, a.at.x) < std::tie(b.at.z, b.at.y, b.at.x);
    });
    return records;
  }

  void send_rays(const RayJob& job) {
    std::vector<std::vector<HostWord>> words;
    for (int k = 0; k < config_.feeders; ++k) words.push_back(ray_words(config_, boxes_, job, k));
    std::vector<std::size_t> sent(words.size());
    send([&](std::size_t k, HostWord& word) {
      if (sent[k] == words[k].size()) return false;
      word = words[k][sent[k]++];
      return true;
    });
  }

  // The hits from all homes, and what follows from them and from the counts that they keep.
  void read_hits(RayResult& result) {
    const auto n = static_cast<std::size_t>(config_.n);
    std::vector<std::vector<std::uint32_t>> values(n * n);
    for (const Reading& reading : read_words(ReadWhat::hits))
      values[static_cast<std::size_t>(reading.at.y) * n + static_cast<std::size_t>(reading.at.x)]
          .push_back(reading.value);
    std::int64_t begun_at_home = 0;
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      const glm::ivec2 home(static_cast<int>(cell % n), static_cast<int>(cell / n));
      const HomeRecord record = unpack_home(config_, home, values[cell]);
      RayCounts& counts = result.counts;
      for (const RayHit& hit : record.hits) {
        ++counts.issued[static_cast<std::size_t>(rays::depth_of(hit.ray.node))];
        ++(hit.facet == RayHit::kNoFacet ? counts.escaped : counts.hits);
        if (hit.ray.node > 1) ++begun_at_home;
        result.hits.push_back(hit);
      }
      counts.rescued += record.rescued;
      counts.too_light += record.too_light;
      counts.too_deep += record.too_deep;
      counts.probes += record.probes;
      counts.planes += record.planes;
      result.traffic.run_on += record.run_on;
      result.traffic.hops += record.hops;
      for (std::size_t stage = 0; stage < kRayStages; ++stage)
        result.traffic.work[stage] = std::max(result.traffic.work[stage], record.work[stage]);
    }
    result.traffic.answers = static_cast<std::int64_t>(result.hits.size());
    result.traffic.sent_again = begun_at_home - result.traffic.run_on;
    sort_hits(result.hits);
  }

  /// Likewise, in the order in which they come: cell after cell.
  std::vector<Reading> read_words(ReadWhat what) {
    std::vector<Reading> records;
    std::vector<bool> asked(static_cast<std::size_t>(config_.feeders));
    send([&](std::size_t k, HostWord& word) {
      if (asked[k]) return false;
      word = HostWord(format_, what);
      asked[k] = true;
      return true;
    });
    top_.m_axis_tready = 1;
    int cell = 0;
    bool ended = false;
    std::int64_t since = cycle_;
    while (!ended) {
      lose_patience(since, "a cell is not read back");
      if (top_.m_axis_tvalid != 0) {
        since = cycle_;
        ended = top_.m_axis_tlast != 0;
        if (!ended) {
          const auto word = unpack_readback(format_, top_.m_axis_tdata);
          if (!word.empty) {
            records.push_back({{cell % config_.n, cell / config_.n, word.z}, word.value});
          }
          if (word.last_of_cell) ++cell;
        }
      }
      tick();
    }
    top_.m_axis_tready = 0;
    if (cell != config_.n * config_.n) throw std::logic_error("the readback missed cells");
    wait_until_idle();
    return records;
  }

  VerilatedContext context_;
  Vrc2_machine top_;
  VerilatedFstC trace_;
  bool tracing_ = false;
  bool waves_listed_ = false;
  bool lighting_ = false;
  QueueObserver observer_;
  std::optional<QueueWatch> queues_;
  std::int64_t cycle_ = 0;
  WaveWindow waves_;
  MachineConfig config_;
  WordFormat format_;
  VoxelMemory voxels_;
  LightMemory light_;
  std::vector<FacetBox> boxes_;
};

}  // namespace
}  // namespace rc2

extern "C" rc2::Machine* rc2_make_verilated_machine(const rc2::WaveWindow& waves) {
  return new rc2::VerilatedMachine(waves);
}
