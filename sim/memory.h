#pragma once

#include <fmt/format.h>

#include <new>

#include "sw/base/error.h"

namespace rc2 {

/// Does the work; if memory runs out, throws an Error that names the one number to blame.
template <typename Work>
auto within_memory(int n, Work work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(
        fmt::format("--n {}: there is not enough memory for a machine of this size; choose "
                    "a smaller one",
                    n));
  }
}

}  // namespace rc2
