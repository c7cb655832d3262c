#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rc2::facet {

/// Reserves room for `count` values that will soon be written. If it is large, Linux is asked for
/// huge pages: page by page, the first write to the packets of a large scene would take longer than
/// all else that is done for them.
template <typename Value>
void reserve_large(std::vector<Value>& values, std::size_t count) {
  values.reserve(count);
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kHugePage = 2 << 20;
  void* first = values.data();
  std::size_t size = values.capacity() * sizeof(Value);
  // A hint: if it is not taken, nothing is lost but time.
  if (std::align(kHugePage, kHugePage, first, size) != nullptr) {
    madvise(first, size / kHugePage * kHugePage, MADV_HUGEPAGE);
  }
#endif
}

}  // namespace rc2::facet
