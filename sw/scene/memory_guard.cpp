#include "sw/scene/memory_guard.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace rc2::scene {

MemoryGuard::MemoryGuard() {
  getrlimit(RLIMIT_AS, &before_);
  // First number of statm: pages of address space in use. Without it nothing is limited.
  rlim_t pages = 0;
  if (!(std::ifstream("/proc/self/statm") >> pages)) return;
  rlimit limit = before_;
  const rlim_t allowed = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + kImportMemory;
  limit.rlim_cur = std::min(before_.rlim_cur, allowed);
  setrlimit(RLIMIT_AS, &limit);
}

MemoryGuard::~MemoryGuard() { setrlimit(RLIMIT_AS, &before_); }

}  // namespace rc2::scene
