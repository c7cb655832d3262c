// Watches a stream: hands on what moves, sees to it that an offer stays until it is taken, and
// counts how often either end waited.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <systemc>

#include "tb/systemc/stream.h"

namespace rc2::tb {

class Monitor : public sc_core::sc_module {
 public:
  struct Counts {
    std::int64_t moved = 0;    ///< beats
    std::int64_t stalled = 0;  ///< cycles in which an offer waited for the sink
  };
  using Moved = std::function<void(const Beat& beat)>;
  /// An offer was not kept; the second is what is offered now, or null.
  using Broken = std::function<void(const Beat& held, const Beat* now)>;

  Monitor(const sc_core::sc_module_name& name, const sc_core::sc_clock& clock, const Stream& stream,
          Moved moved, Broken broken);

  const Counts& counts() const { return counts_; }

 private:
  SC_HAS_PROCESS(Monitor);
  void edge();

  const Stream& stream_;
  Moved moved_;
  Broken broken_;
  Counts counts_;
  std::optional<Beat> held_;  // on offer in the cycle before, and not taken
};

}  // namespace rc2::tb
