#include "sw/cycle/tally.h"

#include <fmt/format.h>

#include <stdexcept>

namespace rc2::cycle {

void check_conservation(const TargetCount& targets) {
  if (targets.absorbed + targets.escaped + targets.skipped != targets.total) {
    throw std::logic_error(
        fmt::format("conservation is broken: {} targets absorbed, {} escaped and {} "
                    "skipped are not {}",
                    targets.absorbed, targets.escaped, targets.skipped, targets.total));
  }
}

}  // namespace rc2::cycle
