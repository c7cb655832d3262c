// rc2_machine through Verilator.
#include "Vrc2_machine.h"
#include "tb/systemc/machine_unit.h"
#include "tb/systemc/verilated_unit.h"

namespace rc2::tb {
namespace {

class RtlMachine final : public VerilatedUnit<Vrc2_machine> {
 public:
  using VerilatedUnit::VerilatedUnit;

  const StreamNames& names() const override { return names_; }

 private:
  void drive(Vrc2_machine& top, const UnitPins& pins) override {
    top.s_axil_awvalid = pins.in[kAw].valid;
    put(top.s_axil_awaddr, pins.in[kAw].beat);
    top.s_axil_wvalid = pins.in[kW].valid;
    put(top.s_axil_wdata, pins.in[kW].beat);
    top.s_axil_arvalid = pins.in[kAr].valid;
    put(top.s_axil_araddr, pins.in[kAr].beat);
    top.s_axil_bready = pins.out[kB].ready;
    top.s_axil_rready = pins.out[kR].ready;
    top.m_axis_tready = pins.out[kReadback].ready;
    const auto bytes = static_cast<std::size_t>(names_.in[kPackets].bits + 7) / 8;
    unsigned valid = 0;
    for (std::size_t k = 0; k < kFeeders; ++k) {
      valid |= static_cast<unsigned>(pins.in[kPackets + k].valid) << k;
      put(top.s_axis_tdata, pins.in[kPackets + k].beat, k * bytes, bytes);
    }
    top.s_axis_tvalid = static_cast<CData>(valid);
  }

  void observe(const Vrc2_machine& top, UnitPins& pins) override {
    pins.in[kAw].ready = top.s_axil_awready != 0;
    pins.in[kW].ready = top.s_axil_wready != 0;
    pins.in[kAr].ready = top.s_axil_arready != 0;
    for (std::size_t k = 0; k < kFeeders; ++k) {
      pins.in[kPackets + k].ready = (top.s_axis_tready >> k & 1U) != 0;
    }
    pins.out[kB].valid = top.s_axil_bvalid != 0;
    pins.out[kB].beat = get(top.s_axil_bresp);
    pins.out[kR].valid = top.s_axil_rvalid != 0;
    pins.out[kR].beat =
        Beat(top.s_axil_rdata | static_cast<std::uint64_t>(top.s_axil_rresp) << kReadResponseBit);
    pins.out[kReadback].valid = top.m_axis_tvalid != 0;
    pins.out[kReadback].beat = get(top.m_axis_tdata);
    pins.out[kReadback].beat.limbs[1] |= std::uint32_t{top.m_axis_tlast} << (kReadLastBit - 32);
  }

  static constexpr std::size_t kFeeders = kMachine.feeders;
  StreamNames names_ = machine_streams();
};

}  // namespace

std::unique_ptr<Unit> make_rtl_machine(const std::string& waves) {
  return std::make_unique<RtlMachine>(waves);
}

}  // namespace rc2::tb
