#include "tb/systemc/unit_module.h"

namespace rc2::tb {

UnitModule::UnitModule(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock,
                       Unit& unit, Streams& in, Streams& out)
    : sc_module(name), unit_(unit), in_(in), out_(out), pins_{{}, {}} {
  pins_.in.resize(in.size());
  pins_.out.resize(out.size());

  SC_METHOD(edge);
  sensitive << clock.posedge_event();
  dont_initialize();

  SC_METHOD(settle);
  sensitive << clocked_;
  for (const auto& stream : in) sensitive << stream->valid << stream->beat;
  for (const auto& stream : out) sensitive << stream->ready;
}

void UnitModule::edge() {
  unit_.clock(pins_);
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void UnitModule::settle() {
  for (std::size_t i = 0; i < in_.size(); ++i) {
    pins_.in[i].valid = in_[i]->valid.read();
    pins_.in[i].beat = in_[i]->beat.read();
  }
  for (std::size_t i = 0; i < out_.size(); ++i) pins_.out[i].ready = out_[i]->ready.read();
  unit_.settle(pins_);
  for (std::size_t i = 0; i < in_.size(); ++i) in_[i]->ready.write(pins_.in[i].ready);
  for (std::size_t i = 0; i < out_.size(); ++i) {
    out_[i]->valid.write(pins_.out[i].valid);
    out_[i]->beat.write(pins_.out[i].beat);
  }
}

}  // namespace rc2::tb
