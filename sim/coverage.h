// What a Verilated model has been through, handed in for scripts/coverage.
#pragma once

#include <verilated.h>
#if VM_COVERAGE
#include <verilated_cov.h>
#endif

#include <stdlib.h>
#include <unistd.h>

#include <string>

namespace rc2 {

/// Writes the counters of a context's models into a file of its own in the folder that
/// RC2_COVERAGE_FOLDER names, if any. To be called while the models are there; forgets the
/// counters, which would dangle.
inline void hand_in_coverage(VerilatedContext& context) {
#if VM_COVERAGE
  if (const char* folder = std::getenv("RC2_COVERAGE_FOLDER")) {
    std::string path = std::string(folder) + "/XXXXXX.dat";
    close(mkstemps(path.data(), 4));
    // Else the points of a generate loop would become one.
    context.coveragep()->forcePerInstance(true);
    context.coveragep()->write(path.c_str());
  }
  context.coveragep()->clear();
#else
  static_cast<void>(context);
#endif
}

}  // namespace rc2
