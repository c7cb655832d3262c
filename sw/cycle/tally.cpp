#include "sw/cycle/tally.h"

#include <fmt/format.h>

#include <stdexcept>

namespace rc2::cycle {

void check_conservation(const TargetCount& targets) {
  if (targets.absorbed + targets.escaped != targets.total) {
    throw std::logic_error(
        fmt::format("conservation is broken: {} targets absorbed and {} escaped "
                    "are not {}",
                    targets.absorbed, targets.escaped, targets.total));
  }
}

}  // namespace rc2::cycle
