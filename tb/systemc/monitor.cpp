#include "tb/systemc/monitor.h"

namespace rc2::tb {

Monitor::Monitor(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock,
                 const Stream& stream, Moved moved, Broken broken)
    : sc_module(name), stream_(stream), moved_(std::move(moved)), broken_(std::move(broken)) {
  SC_METHOD(edge);
  sensitive << clock.posedge_event();
  dont_initialize();
}

void Monitor::edge() {
  const bool valid = stream_.valid.read();
  const Beat& beat = stream_.beat.read();
  if (held_ && (!valid || beat != *held_)) broken_(*held_, valid ? &beat : nullptr);
  held_.reset();
  if (stream_.moves()) {
    ++counts_.moved;
    moved_(beat);
  } else if (valid) {
    ++counts_.stalled;
    held_ = beat;
  }
}

}  // namespace rc2::tb
