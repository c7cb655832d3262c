#include "tb/systemc/stream.h"

#include <algorithm>

namespace rc2::tb {
namespace {

void trace_limbs(sc_core::sc_trace_file* file, const Beat& beat, const std::string& name,
                 int bits) {
  for (int at = 0; at < bits; at += 32) {
    const auto limb = static_cast<std::size_t>(at) / 32;
    sc_core::sc_trace(file, beat.limbs[limb], name + "_" + std::to_string(limb),
                      std::min(32, bits - at));
  }
}

}  // namespace

void sc_trace(sc_core::sc_trace_file* file, const Beat& beat, const std::string& name) {
  trace_limbs(file, beat, name, 32 * HostWord::kLimbs);
}

void Stream::trace(sc_core::sc_trace_file* file) const {
  sc_core::sc_trace(file, valid, valid.name());
  sc_core::sc_trace(file, ready, ready.name());
  trace_limbs(file, beat.read(), beat.name(), bits);
}

}  // namespace rc2::tb
