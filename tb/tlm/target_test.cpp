// The TLM-2.0 target: what goes through it is what goes into the machine directly, its time is the
// machine's, and what cannot be is answered with the right error and changes nothing.
#include "sw/tlm/target.h"

#include <gtest/gtest.h>
#include <tlm_utils/simple_initiator_socket.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sw/cycle/cycle_machine.h"
#include "sw/machine/feeder.h"
#include "sw/machine/host_port.h"
#include "sw/machine/readback.h"
#include "sw/tlm/memory_map.h"
#include "tb/unit/random_packets.h"

namespace rc2 {
namespace {

using namespace host_port;
using ::tlm::tlm_command;
using ::tlm::tlm_response_status;

constexpr MachineConfig kConfig{5, 4, 20, 16, 1, true};
constexpr double kPeriod = 10;  // nanoseconds
constexpr std::int64_t kRegisterCycles = 2;

class Initiator : public sc_core::sc_module {
 public:
  explicit Initiator(const sc_core::sc_module_name& name) : sc_module(name), socket("socket") {}
  tlm_utils::simple_initiator_socket<Initiator> socket;
};

/// The platform of all tests: SystemC can be elaborated once only.
struct Platform {
  Platform() { initiator.socket.bind(target.socket); }
  cycle::CycleMachine machine{kConfig};
  tlm::Target target{"target", machine, sc_core::sc_time(kPeriod, sc_core::SC_NS)};
  Initiator initiator{"initiator"};
};
Platform* platform = nullptr;

class Target : public testing::Test {
 protected:
  void SetUp() override { write(kCommand, kCommandClear); }

  /// The status of one transaction; cycles_ tells its time.
  tlm_response_status transfer(tlm_command command, std::uint64_t address, void* data,
                               std::size_t bytes, std::size_t streaming_width = 1 << 20,
                               unsigned char* enables = nullptr) {
    ::tlm::tlm_generic_payload transaction;
    transaction.set_command(command);
    transaction.set_address(address);
    transaction.set_data_ptr(static_cast<unsigned char*>(data));
    transaction.set_data_length(static_cast<unsigned>(bytes));
    transaction.set_streaming_width(static_cast<unsigned>(streaming_width));
    transaction.set_byte_enable_ptr(enables);
    sc_core::sc_time delay;
    platform->initiator.socket->b_transport(transaction, delay);
    cycles_ = std::llround(delay / sc_core::sc_time(kPeriod, sc_core::SC_NS));
    const bool failed = transaction.is_response_error();
    EXPECT_EQ(platform->target.last_error().empty(), !failed);
    return transaction.get_response_status();
  }

  std::uint32_t read(std::uint64_t address) {
    std::uint32_t value = 0;
    EXPECT_EQ(transfer(::tlm::TLM_READ_COMMAND, address, &value, 4), ::tlm::TLM_OK_RESPONSE);
    return value;
  }
  tlm_response_status try_write(std::uint64_t address, std::uint32_t value) {
    return transfer(::tlm::TLM_WRITE_COMMAND, address, &value, 4);
  }
  void write(std::uint64_t address, std::uint32_t value) {
    EXPECT_EQ(try_write(address, value), ::tlm::TLM_OK_RESPONSE);
  }

  tlm_response_status send(const Word& word) {
    auto limbs = HostWord(format_, word).limbs();
    return transfer(::tlm::TLM_WRITE_COMMAND, tlm::kPackets, limbs.data(), sizeof limbs);
  }

  void load(const facet::PacketStream& packets) {
    std::vector<HostWord::Limbs> words;
    for (FeederWords feeder(packets, 0, 1); !feeder.done();) {
      words.push_back(HostWord(format_, feeder.next()).limbs());
    }
    constexpr std::size_t kAtOnce = tlm::kPacketsSize / tlm::kPacketBytes;
    for (std::size_t first = 0; first < words.size(); first += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, words.size() - first);
      ASSERT_EQ(transfer(::tlm::TLM_WRITE_COMMAND, tlm::kPackets, &words[first],
                         count * tlm::kPacketBytes),
                ::tlm::TLM_OK_RESPONSE);
      ASSERT_EQ(cycles_, static_cast<std::int64_t>(count));
    }
  }

  std::vector<std::uint64_t> ask(ReadWhat what) {
    auto question = HostWord(format_, what).limbs();
    EXPECT_EQ(transfer(::tlm::TLM_WRITE_COMMAND, tlm::kPackets, question.data(), tlm::kPacketBytes),
              ::tlm::TLM_OK_RESPONSE);
    std::vector<std::uint64_t> beats(read(tlm::kWaiting));
    EXPECT_EQ(transfer(::tlm::TLM_READ_COMMAND, tlm::kReadback, beats.data(),
                       beats.size() * tlm::kReadbackBytes),
              ::tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(cycles_, static_cast<std::int64_t>(beats.size()));
    return beats;
  }

  static std::vector<std::uint64_t> all_beats(const Readback& readback) {
    std::vector<std::uint64_t> beats;
    for (const auto& cell : readback.beats()) beats.insert(beats.end(), cell.begin(), cell.end());
    beats.push_back(tlm::kReadbackEnd);
    return beats;
  }

  tlm_response_status light(const LightJob& job) {
    write(kSourceX, static_cast<std::uint32_t>(job.source.x));
    write(kSourceY, static_cast<std::uint32_t>(job.source.y));
    write(kSourceZ, static_cast<std::uint32_t>(job.source.z));
    write(kDistance, static_cast<std::uint32_t>(job.target_distance));
    write(kFa, static_cast<std::uint32_t>(job.fa));
    write(kTargets, static_cast<std::uint32_t>(total_targets(job.target_distance)));
    write(kRule, job.rule == LightRule::accurate ? kRuleAccurate : 0);
    return try_write(kCommand, kCommandStart);
  }

  const WordFormat format_{kConfig};
  std::int64_t cycles_ = 0;
};

TEST_F(Target, SaysWhatItIs) {
  EXPECT_EQ(read(kId), kMachineId);
  EXPECT_EQ(read(kN), 5U);
  EXPECT_EQ(read(kF), 4U);
  EXPECT_EQ(read(kLmax), 20U);
  EXPECT_EQ(read(kFamax), 16U);
  EXPECT_EQ(read(kPacketBits), static_cast<std::uint32_t>(format_.packet_bits()));
  EXPECT_EQ(read(kReadbackBits), static_cast<std::uint32_t>(format_.readback_bits()));
  EXPECT_EQ(read(kFacetNumberBits), static_cast<std::uint32_t>(kFacetBits));
  EXPECT_EQ(read(kFeeders), 1U);
  EXPECT_EQ(read(kLayers), 1U);
  EXPECT_EQ(cycles_, kRegisterCycles);
}

TEST_F(Target, DoesWhatTheMachineDoes) {
  cycle::CycleMachine direct(kConfig);
  Dice dice(3);
  int lights = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    write(kCommand, kCommandClear);
    const auto packets = random_layers(dice, kConfig.n, pick(dice, 1, 50), 40);
    direct.load(packets, {});
    ASSERT_NO_FATAL_FAILURE(load(packets));
    read(kStatus);
    const std::int64_t loading = cycles_ - kRegisterCycles;
    ASSERT_EQ(loading, read(kBusyCycles));
    ASSERT_GT(loading, 0);
    ASSERT_EQ(ask(ReadWhat::voxels), all_beats(readback_of(kConfig, direct.read_voxels())));
    ASSERT_EQ(ask(ReadWhat::layers), all_beats(readback_of(kConfig, direct.read_layers())));

    const LightJob job{pick_voxel(dice, kConfig.n), pick(dice, 1, 20), pick(dice, 1, 16),
                       round % 2 == 0 ? LightRule::accurate : LightRule::thesis};
    const auto voxels = direct.read_voxels();
    const bool free = std::none_of(voxels.begin(), voxels.end(),
                                   [&](const VoxelRecord& v) { return v.at == job.source; });
    if (!free) {
      ASSERT_EQ(light(job), ::tlm::TLM_GENERIC_ERROR_RESPONSE);
      ASSERT_NE(platform->target.last_error().find("occupied by facet"), std::string::npos);
      continue;
    }
    ++lights;
    const LightResult result = direct.light(job, {});
    ASSERT_EQ(light(job), ::tlm::TLM_OK_RESPONSE);
    ASSERT_EQ(cycles_, result.prepare_cycles + result.cycles + kRegisterCycles);
    ASSERT_EQ(read(kStatus), kStatusHome);
    ASSERT_EQ(read(kHome), result.targets.total);
    ASSERT_EQ(read(kHomeCycle), result.home_cycles);
    ASSERT_EQ(read(tlm::kVisitsLow), result.visits);
    ASSERT_EQ(read(tlm::kVisitsHigh), 0U);
    ASSERT_EQ(read(tlm::kDeepestQueue), result.max_queue);
    ASSERT_EQ(read(tlm::kAbsorbed), result.targets.absorbed);
    ASSERT_EQ(read(tlm::kPrepareCycles), result.prepare_cycles);
    ASSERT_EQ(ask(ReadWhat::light), all_beats(readback_of(kConfig, voxels, direct.read_light())));
  }
  EXPECT_GT(lights, 20);
}

TEST_F(Target, AddsPacketsUntilItIsCleared) {
  Dice dice(4);
  const auto first = random_packets(dice, kConfig.n, 3, 4);
  load(first);
  const auto before = ask(ReadWhat::voxels);
  facet::PacketStream none;
  load(none);
  EXPECT_EQ(ask(ReadWhat::voxels), before);
  write(kCommand, kCommandClear);
  EXPECT_EQ(ask(ReadWhat::voxels), all_beats(readback_of(kConfig, VoxelMemory{})));
}

TEST_F(Target, RefusesWhatCannotBe) {
  constexpr auto kRead = ::tlm::TLM_READ_COMMAND;
  constexpr auto kWrite = ::tlm::TLM_WRITE_COMMAND;
  struct Case {
    tlm_command command;
    std::uint64_t address;
    std::size_t bytes;
    tlm_response_status status;
  };
  const Case cases[] = {
      {kRead, 0x80, 4, ::tlm::TLM_ADDRESS_ERROR_RESPONSE},  // beyond the last register
      {kWrite, 0x80, 4, ::tlm::TLM_ADDRESS_ERROR_RESPONSE},
      {kRead, 0x100, 4, ::tlm::TLM_ADDRESS_ERROR_RESPONSE},   // between the windows
      {kRead, 0x3000, 8, ::tlm::TLM_ADDRESS_ERROR_RESPONSE},  // beyond them
      {kWrite, 0x1FE0, 64, ::tlm::TLM_ADDRESS_ERROR_RESPONSE},
      {kRead, ~0ULL - 3, 4, ::tlm::TLM_ADDRESS_ERROR_RESPONSE},
      {kRead, 0x01, 4, ::tlm::TLM_BURST_ERROR_RESPONSE},
      {kRead, 0x00, 8, ::tlm::TLM_BURST_ERROR_RESPONSE},
      {kWrite, 0x40, 2, ::tlm::TLM_BURST_ERROR_RESPONSE},
      {kWrite, 0x1000, 31, ::tlm::TLM_BURST_ERROR_RESPONSE},
      {kWrite, 0x1010, 32, ::tlm::TLM_BURST_ERROR_RESPONSE},
      {kWrite, 0x1000, 0, ::tlm::TLM_BURST_ERROR_RESPONSE},
      {kRead, 0x2004, 8, ::tlm::TLM_BURST_ERROR_RESPONSE},
      {kWrite, kId, 4, ::tlm::TLM_COMMAND_ERROR_RESPONSE},
      {kWrite, kStatus, 4, ::tlm::TLM_COMMAND_ERROR_RESPONSE},
      {kRead, 0x1000, 32, ::tlm::TLM_COMMAND_ERROR_RESPONSE},
      {kWrite, 0x2000, 8, ::tlm::TLM_COMMAND_ERROR_RESPONSE},
      {kRead, 0x2000, 8, ::tlm::TLM_GENERIC_ERROR_RESPONSE},  // nothing waits
  };
  std::vector<unsigned char> data(128);
  for (const Case& c : cases) {
    EXPECT_EQ(transfer(c.command, c.address, data.data(), c.bytes), c.status)
        << std::hex << c.address << ", " << c.bytes;
  }
  EXPECT_EQ(transfer(kRead, kN, data.data(), 4, 2), ::tlm::TLM_BURST_ERROR_RESPONSE);
  unsigned char enable = 0xFF;
  EXPECT_EQ(transfer(kRead, kN, data.data(), 4, 4, &enable), ::tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
  EXPECT_EQ(transfer(::tlm::TLM_IGNORE_COMMAND, 0x5000, data.data(), 4), ::tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(ask(ReadWhat::voxels), all_beats(readback_of(kConfig, VoxelMemory{})));
}

TEST_F(Target, RefusesWordsOutOfPlaceUntilItIsCleared) {
  const std::vector<std::vector<WordKind>> wrong{
      {WordKind::slab},
      {WordKind::head, WordKind::side},
      {WordKind::head, WordKind::gap},
      {WordKind::head, WordKind::slab, WordKind::head},
      {WordKind::head, WordKind::slab, WordKind::end},
      {WordKind::data},
  };
  for (const auto& kinds : wrong) {
    for (const WordKind& kind : kinds) {
      Word word{kind};
      word.take = {1, 1};
      EXPECT_EQ(send(word), &kind == &kinds.back() ? ::tlm::TLM_GENERIC_ERROR_RESPONSE
                                                   : ::tlm::TLM_OK_RESPONSE);
    }
    EXPECT_NE(platform->target.last_error().find("out of place"), std::string::npos);
    write(kCommand, kCommandClear);
  }
}

TEST_F(Target, RefusesWhatTheMachineRefuses) {
  Dice dice(5);
  auto packets = random_packets(dice, kConfig.n, 1, 4);
  packets.heads[0].lo = {0, 0, 0};
  packets.heads[0].hi = {kConfig.n, 1, 1};  // one too many
  load(packets);
  std::uint32_t status = 0;
  EXPECT_EQ(transfer(::tlm::TLM_READ_COMMAND, kStatus, &status, 4),
            ::tlm::TLM_GENERIC_ERROR_RESPONSE);
  EXPECT_NE(platform->target.last_error().find("out of the cube"), std::string::npos);
  write(kCommand, kCommandClear);
  EXPECT_EQ(light({{0, 0, 0}, kConfig.max_distance + 1, 1}), ::tlm::TLM_GENERIC_ERROR_RESPONSE);
  write(kSourceX, ~0U);
  EXPECT_EQ(try_write(kCommand, kCommandStart), ::tlm::TLM_GENERIC_ERROR_RESPONSE);
  auto counters = HostWord(format_, ReadWhat::counters).limbs();
  EXPECT_EQ(transfer(::tlm::TLM_WRITE_COMMAND, tlm::kPackets, counters.data(), sizeof counters),
            ::tlm::TLM_GENERIC_ERROR_RESPONSE);
}

TEST(HostPort, NeedsTargetsThatARegisterCanCount) {
  MachineConfig config{4, 4, 13377, 1, 1, true};
  cycle::CycleMachine fits(config);
  EXPECT_NO_THROW(tlm::HostPort port(fits));
  ++config.max_distance;
  cycle::CycleMachine too_large(config);
  EXPECT_THROW(tlm::HostPort port(too_large), Error);
}

}  // namespace
}  // namespace rc2

int sc_main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  rc2::Platform made;
  rc2::platform = &made;
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  return RUN_ALL_TESTS();
}
