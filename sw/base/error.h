#pragma once

#include <stdexcept>

namespace rc2 {

/// Anything the user can mend: the message says what is wrong, where, why, and what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rc2
