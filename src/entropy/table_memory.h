#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace unstep::entropy {

/// Gives a table's memory back.
struct FreeTable {
  std::size_t mapped = 0;  ///< bytes; 0: from the heap

  void operator()(void* table) const {
#if defined(__linux__)
    if (mapped != 0) {
      ::munmap(table, mapped);
      return;
    }
#endif
    std::free(table);
  }
};

template <class T>
using Table = std::unique_ptr<T[], FreeTable>;

/// `size` zeros of a type for which zeros are a value. The system need not
/// provide what is never touched. Hashed tables are read all over, so that
/// most of the time goes into finding pages: large ones ask for huge pages.
/// Throws std::bad_alloc.
template <class T>
[[nodiscard]] Table<T> make_table(std::size_t size) {
  if (size > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T)) {
    throw std::bad_alloc();
  }
#if defined(__linux__)
  constexpr std::size_t kHuge = std::size_t{2} << 20;
  const std::size_t bytes = (size * sizeof(T) + kHuge - 1) & ~(kHuge - 1);
  if (size * sizeof(T) >= kHuge) {
    // One huge page more than needed, of which the ends go back.
    void* all = ::mmap(nullptr, bytes + kHuge, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) throw std::bad_alloc();
    auto* begin = static_cast<std::byte*>(all);
    const std::size_t before =
        -reinterpret_cast<std::uintptr_t>(begin) & (kHuge - 1);
    if (before != 0) ::munmap(begin, before);
    begin += before;
    ::munmap(begin + bytes, kHuge - before);
    ::madvise(begin, bytes, MADV_HUGEPAGE);  // small pages do as well
    return Table<T>(reinterpret_cast<T*>(begin), FreeTable{bytes});
  }
#endif
  auto* table = static_cast<T*>(std::calloc(size, sizeof(T)));
  if (table == nullptr) throw std::bad_alloc();
  return Table<T>(table, FreeTable{});
}

/// `size` copies of `value`, for types for which zeros are none. Copied in
/// growing parts: of a small file this is most of the work.
template <class T>
[[nodiscard]] Table<T> make_table(std::size_t size, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  Table<T> table = make_table<T>(size);
  if (size == 0) return table;
  table[0] = value;
  for (std::size_t done = 1; done < size;) {
    const std::size_t more = std::min(done, size - done);
    std::memcpy(table.get() + done, table.get(), more * sizeof(T));
    done += more;
  }
  return table;
}

}  // namespace unstep::entropy
