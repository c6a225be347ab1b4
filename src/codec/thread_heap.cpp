#include "codec/thread_heap.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

#if defined(__linux__) && defined(__GLIBC__) && defined(__LP64__)
#include <sys/mman.h>
#define UNSTEP_HAS_THREAD_HEAPS
#endif

namespace unstep::codec {

void prepare_thread_heap() {
#if defined(UNSTEP_HAS_THREAD_HEAPS)
  // What glibc gives a thread: addresses that begin at a multiple of their
  // size, the books of the heap first (malloc/arena.c, HEAP_MAX_SIZE).
  constexpr std::size_t kHeap = std::size_t{64} << 20;
  constexpr std::size_t kBooks = 16 << 10;
  constexpr std::size_t kHuge = std::size_t{2} << 20;
  void* const block = std::malloc(1);
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  const std::size_t used = address % kHeap;
  std::free(block);
  // Another heap, or one that an earlier thread left and had prepared.
  if (block == nullptr || used > kBooks) return;
  // No more than advice: whoever owns the addresses loses nothing.
  ::madvise(reinterpret_cast<void*>(address - used), kHeap, MADV_HUGEPAGE);
  // The first large page is a row of small ones already, since its first was
  // touched. Left out, as long as the thread lives.
  thread_local std::unique_ptr<void, decltype(&std::free)> rest(nullptr,
                                                                &std::free);
  rest.reset(std::malloc(kHuge - used));
#endif
}

}  // namespace unstep::codec
