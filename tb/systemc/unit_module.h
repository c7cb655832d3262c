// Any Unit as a SystemC module on a clock.
#pragma once

#include <memory>
#include <systemc>
#include <vector>

#include "tb/systemc/stream.h"

namespace rc2::tb {

using Streams = std::vector<std::unique_ptr<Stream>>;

class UnitModule : public sc_core::sc_module {
 public:
  UnitModule(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock, Unit& unit,
             Streams& in, Streams& out);

 private:
  SC_HAS_PROCESS(UnitModule);
  void edge();
  // Runs after every edge and whenever the others drive something new.
  void settle();

  Unit& unit_;
  Streams &in_, &out_;
  UnitPins pins_;
  sc_core::sc_event clocked_;
};

}  // namespace rc2::tb
