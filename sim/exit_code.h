#pragma once

namespace rc2 {

/// What the program returns to the shell.
enum ExitCode {
  kDone = 0,
  kDifferent = 1,     ///< compare: the files differ
  kBadInput = 2,      ///< the user can mend it
  kDisagreement = 3,  ///< the machine and what it is compared with differ
  kBroken = 4,        ///< a law that holds for every machine is broken
};

}  // namespace rc2
