#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// The warm start of coder 3: what its models of lines know before the first
/// bit, learned from other drawings by tests/bench/train_centrelines.cpp, which
/// makes centreline_warm_start_table.cpp. Part of the format (docs/format.md):
/// a changed table is a new table id. Characters are those of warm_start.h.
namespace unstep::codec::centreline_warm {

inline constexpr std::size_t kContexts = 8;

/// What is known of one decision after a context.
struct Counter {
  std::uint8_t node = 0;
  std::uint8_t n = 0;
  std::uint16_t p = 32768;
};

/// A slot: the upper 16 bits of its hash, the 16 after them, and up to
/// kMostCounters counters.
struct Record {
  static constexpr std::size_t kMostCounters = 4;

  std::uint16_t index = 0;
  std::uint16_t check = 0;
  std::size_t size = 0;
  std::array<Counter, kMostCounters> counters{};
};

/// Ages of stored counters.
inline constexpr std::array<std::uint8_t, 8> kAges{1, 2, 4, 7, 11, 16, 22, 30};

/// Takes records apart. Each is told by how many indices are passed over since
/// the one before of its context (one character; 63: three more, the number),
/// then the check and, below it, the number of counters less one (three
/// characters), then the counters (node and place of the age; level).
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}
  /// The next context begins.
  void begin() { index_ = 0; }
  /// REQUIRES: a record is left.
  Record next();

 private:
  unsigned take(int characters);

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t index_ = 0;  ///< the next that may come
};

struct Table {
  std::array<std::uint16_t, kContexts> counts;  ///< of records, by context
  std::string_view records;

  /// Calls `apply(context, record)` for all records.
  template <class Apply>
  void for_each(Apply apply) const {
    Reader reader(records);
    for (std::size_t i = 0; i < kContexts; ++i) {
      reader.begin();
      for (std::size_t k = 0; k < counts[i]; ++k) apply(i, reader.next());
    }
  }
};

/// The table of the format.
extern const Table kTable;

}  // namespace unstep::codec::centreline_warm
