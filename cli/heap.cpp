#include "cli/heap.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#if defined(__linux__) && defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace unstep::cli {

void prepare_heap() {
#if defined(__linux__) && defined(__GLIBC__)
  constexpr int kGrowth = 64 << 20;      // addresses, not memory
  constexpr int kOwnMapping = 32 << 20;  // the most that glibc allows
  constexpr std::uintptr_t kHuge = std::uintptr_t{2} << 20;
  if (::mallopt(M_TOP_PAD, kGrowth) == 0 ||
      ::mallopt(M_TRIM_THRESHOLD, 2 * kGrowth) == 0 ||
      ::mallopt(M_MMAP_THRESHOLD, kOwnMapping) == 0) {
    return;
  }
  const auto begin = reinterpret_cast<std::uintptr_t>(::sbrk(0));
  // Beyond what the heap has already, or it would not grow.
  const std::uintptr_t first = (begin + kHuge / 2 + kHuge - 1) & ~(kHuge - 1);
  // Kept and never touched, so that what follows lies in large pages.
  static void* const before = std::malloc(first - begin + 1);
  const auto end = reinterpret_cast<std::uintptr_t>(::sbrk(0));
  if (before == nullptr || end <= first) return;  // another allocator's heap
  ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace unstep::cli
