#include "tb/systemc/ends.h"

namespace rc2::tb {

Driver::Driver(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock, Stream& stream,
               std::uint64_t seed)
    : sc_module(name), stream_(stream), pacer_(seed) {
  SC_METHOD(edge);
  sensitive << clock.posedge_event();
  dont_initialize();
}

void Driver::edge() {
  bool offering = stream_.valid.read();
  if (offering && stream_.ready.read()) {
    waiting_.pop_front();
    offering = false;
  }
  const bool go = pacer_.go();
  if (!offering && go && !waiting_.empty()) {
    stream_.beat.write(waiting_.front());
    offering = true;
  }
  stream_.valid.write(offering);
}

Sink::Sink(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock, Stream& stream,
           std::uint64_t seed)
    : sc_module(name), stream_(stream), pacer_(seed) {
  SC_METHOD(edge);
  sensitive << clock.posedge_event();
  dont_initialize();
}

}  // namespace rc2::tb
