// The two ends of a stream that the bench holds, both of which stall at random: a driver for an
// input of the unit, a sink for an output.
#pragma once

#include <deque>
#include <systemc>

#include "tb/systemc/pacer.h"
#include "tb/systemc/stream.h"

namespace rc2::tb {

/// Offers beats in order; one that is offered stays until it is taken.
class Driver : public sc_core::sc_module {
 public:
  Driver(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock, Stream& stream,
         std::uint64_t seed);

  void send(const Beat& beat) { waiting_.push_back(beat); }
  bool idle() const { return waiting_.empty(); }
  Pacer& pacer() { return pacer_; }

 private:
  SC_HAS_PROCESS(Driver);
  void edge();

  Stream& stream_;
  Pacer pacer_;
  std::deque<Beat> waiting_;  // the first is on offer while `valid` is set
};

/// Takes whatever comes.
class Sink : public sc_core::sc_module {
 public:
  Sink(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock, Stream& stream,
       std::uint64_t seed);

  Pacer& pacer() { return pacer_; }

 private:
  SC_HAS_PROCESS(Sink);
  void edge() { stream_.ready.write(pacer_.go()); }

  Stream& stream_;
  Pacer pacer_;
};

}  // namespace rc2::tb
