#pragma once

#include <sys/resource.h>

#include <cstdint>

namespace rc2::scene {

constexpr std::int64_t kImportMemory = 2'000'000'000;  ///< bytes an import may take

/// While it lives, the process may not grow by more than kImportMemory. Some damaged files make
/// Assimp collect numbers without end; so it meets std::bad_alloc before the computer runs out.
class MemoryGuard {
 public:
  MemoryGuard();
  ~MemoryGuard();
  MemoryGuard(const MemoryGuard&) = delete;
  MemoryGuard& operator=(const MemoryGuard&) = delete;

 private:
  rlimit before_;
};

}  // namespace rc2::scene
