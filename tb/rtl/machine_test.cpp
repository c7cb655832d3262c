// The registers of rc2_machine: those that a host may write keep as many bits as they have, one
// does not touch another, and the others say what was built.
#include <map>

#include "sw/machine/host_port.h"
#include "tb/rtl/block.h"

namespace {

using namespace rc2::host_port;

class Registers : public testing::Test {
 protected:
  Registers() {
    port.top.s_axil_awvalid = 0;
    port.top.s_axil_wvalid = 0;
    port.top.s_axil_arvalid = 0;
    port.top.s_axil_bready = 1;
    port.top.s_axil_rready = 1;
    port.top.s_axis_tvalid = 0;
    port.top.m_axis_tready = 1;
    for (int i = 0; i < 20; ++i) port.tick();  // it may have been busy, and finds that it is not
  }

  void write(Register address, std::uint32_t value) {
    port.top.s_axil_awvalid = 1;
    port.top.s_axil_wvalid = 1;
    port.top.s_axil_awaddr = address;
    port.top.s_axil_wdata = value;
    port.tick();
    port.top.s_axil_awvalid = 0;
    port.top.s_axil_wvalid = 0;
    port.tick();
  }

  std::uint32_t read(int address) {
    port.top.s_axil_arvalid = 1;
    port.top.s_axil_araddr = static_cast<CData>(address);
    port.tick();
    port.top.s_axil_arvalid = 0;
    const std::uint32_t value = port.top.s_axil_rdata;
    port.tick();
    return value;
  }

  rc2::tb::Clocked<Vtop> port;
  rc2::tb::Dice dice{14};
};

TEST_F(Registers, KeepWhatIsWritten) {
  // n = 2, L up to 8, FA up to 32: a coordinate has one bit, L four, FA six, 24*L*L + 2 eleven, and
  // 1/L has one and a fraction of ten; without rays they have no limits.
  const std::map<Register, int> bits{{kSourceX, 1},  {kSourceY, 1}, {kSourceZ, 1},
                                     {kDistance, 4}, {kFa, 6},      {kTargets, 11},
                                     {kInverse, 11}, {kRule, 1},    {kRayLimits, 0}};
  std::map<Register, std::uint32_t> kept;
  for (const auto& [address, width] : bits) kept[address] = 0;
  for (int round = 0; round < 1000; ++round) {
    for (const auto& [address, width] : bits) {
      if (dice.chance(60)) continue;
      const auto value = static_cast<std::uint32_t>(dice.bits());
      write(address, value);
      kept[address] = value & ((1U << width) - 1);
    }
    for (const auto& [address, value] : kept) ASSERT_EQ(read(address), value) << address;
  }
}

TEST_F(Registers, SayWhatWasBuilt) {
  EXPECT_EQ(read(kId), kMachineId);
  EXPECT_EQ(read(kN), 2U);
  EXPECT_EQ(read(kF), 1U);
  EXPECT_EQ(read(kLmax), 8U);
  EXPECT_EQ(read(kFamax), 32U);
  EXPECT_EQ(read(kFeeders), 1U);
  EXPECT_EQ(read(kLayers), 1U);
  EXPECT_EQ(read(kBuild), static_cast<std::uint32_t>(kBuildCounts | kBuildSkips));
  EXPECT_EQ(read(kInverseBits), 11U);
  EXPECT_EQ(read(kStatus) & kStatusBusy, 0U);
  EXPECT_EQ(read(0x7C), 0U);  // there is none
}

}  // namespace
