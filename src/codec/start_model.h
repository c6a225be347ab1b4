#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/crack_map.h"
#include "codec/far_flag_model.h"
#include "codec/quiet_span_model.h"
#include "codec/warm_start.h"
#include "entropy/counter.h"
#include "entropy/mixer.h"
#include "grid/bit_count.h"

namespace unstep::codec {

/// Predicts where contours start. The scan visits 64 grid points of a row at a
/// time. Far from known cracks, one flag says whether a start is among the
/// candidates and a uniform index says where; near known cracks each candidate
/// has its own flag under the cracks around it.
class StartModel {
 public:
  StartModel(const CrackMap& cracks, const warm::Table& start);

  /// Candidate starts among the 64 points of `word` in row y.
  struct Candidates {
    std::uint64_t near = 0;               ///< beside known cracks, not likely
    std::uint64_t likely = 0;             ///< near ones under thin ink
    std::array<std::uint64_t, 2> open{};  ///< far, on paper and on ink
  };
  /// `above`: the pixels of row y - 1 at these points.
  [[nodiscard]] Candidates candidates(std::int32_t y, std::int32_t word,
                                      std::uint64_t above, std::uint64_t used);
  /// Cracks have been marked since the last candidates().
  void walked() { stale_ = true; }

  /// How many words from `word` on have no start: a whole quiet span, if its
  /// flag says so, or 0. `above`: the pixels of the row before; `any_start(n)`:
  /// whether one of the next n words has a start (encoder only).
  template <class Coder, class AnyStart>
  std::int32_t code_quiet_span(Coder& coder, std::int32_t word,
                               const std::vector<std::uint64_t>& above,
                               const AnyStart& any_start) {
    if (!is_quiet_span(word, above)) return 0;
    const bool ink = above[static_cast<std::size_t>(word)] != 0;
    if (!spans_.code(coder, word, ink, any_start(QuietSpanModel::kWords))) {
      return QuietSpanModel::kWords;
    }
    span_end_ = word + QuietSpanModel::kWords;
    span_found_ = false;
    return 0;
  }

  void begin_row(std::int32_t y);

  /// Whether one of the open candidates `mask` (not 0) is a start, and which:
  /// returns its bit or 0. `starts`: the true starts (encoder only).
  template <class Coder>
  std::uint64_t code_open(Coder& coder, std::uint64_t mask, std::int32_t word,
                          bool ink, std::uint64_t starts) {
    Column& column = columns_[ink ? 1 : 0][static_cast<std::size_t>(word) + 1];
    const bool truth = (starts & mask) != 0;
    if (word < span_end_) {
      entropy::Counter& flag =
          spans_.word_flag(word, age_level(column), span_found_);
      const bool any = coder.code(truth, flag.p1_fine());
      flag.update(any);
      if (!any) return 0;
      far_.count(static_cast<std::size_t>(word), ink);
      span_found_ = true;
    } else {
      const bool any = coder.code(truth, predict_open(mask, word, ink));
      far_.update(any);
      if (!any) return 0;
    }
    spans_.count(word, ink);
    ++row_starts_[ink ? 1 : 0];
    const std::uint64_t bit =
        code_place(coder, mask, starts & mask, word * 64, column, ink);
    row_last_[ink ? 1 : 0] = word * 64 + std::countl_zero(bit);
    column = {y_, bit};
    return bit;
  }

  /// Whether one of the near candidates `mask` (not 0) of the word at x is a
  /// start, and which is the first: returns its bit or 0. `above`: the pixels
  /// of the row before.
  template <class Coder>
  std::uint64_t code_near(Coder& coder, std::uint64_t mask, std::int32_t x,
                          std::int32_t y, std::uint64_t above,
                          std::uint64_t starts) {
    entropy::Counter& counter = flags_[group_context(mask, above, x, y)];
    const bool any = coder.code((starts & mask) != 0, counter.p1_fine());
    counter.update(any);
    if (!any) return 0;
    ++row_near_;
    for (;;) {
      const std::uint64_t bit = std::bit_floor(mask);
      mask &= ~bit;
      if (mask == 0) return bit;  // one of them is
      if (code_one(coder, bit, x, y, above, starts)) return bit;
    }
  }

  /// Whether the near candidate `bit` of the word at x is a start.
  template <class Coder>
  bool code_one(Coder& coder, std::uint64_t bit, std::int32_t x, std::int32_t y,
                std::uint64_t above, std::uint64_t starts) {
    predict_near(x + std::countl_zero(bit), y, (above & bit) != 0);
    const bool start = coder.code((starts & bit) != 0, probability());
    update_near(start);
    return start;
  }

  static constexpr std::size_t kContexts = 3;
  static constexpr std::size_t kOpenFlags = 2 * 4 * 4 * 4 * 8;
  static constexpr std::size_t kSameFlags = kOpenFlags + 8 * 5 * 3 * 2;
  static constexpr std::size_t kPlaces = kSameFlags + 2 * 8;
  static constexpr std::size_t kFlags = kPlaces + 2 * 3 * 64;

  /// log2 of a context's counters: the first is indexed by the cracks
  /// themselves, the others by a hash.
  static constexpr int near_bits(std::size_t context) {
    return context == 0 ? 16 : 14;
  }
  static constexpr std::size_t near_first(std::size_t context) {
    return context == 0 ? 0 : (std::size_t{1} << 16) + ((context - 1) << 14);
  }

  /// What was learned, for training a warm start.
  [[nodiscard]] std::span<const entropy::Counter> flags() const {
    return flags_;
  }
  [[nodiscard]] std::span<const entropy::Counter> near(
      std::size_t context) const {
    return {near_.data() + near_first(context),
            std::size_t{1} << near_bits(context)};
  }
  [[nodiscard]] const auto& mixer() const { return mixer_; }

 private:
  /// The last far start among the points of a word.
  struct Column {
    std::int32_t y = -(1 << 20);
    std::uint64_t bit = 0;
  };

  /// Which of `mask` is a start: the place of the last one in these columns,
  /// or any.
  template <class Coder>
  std::uint64_t code_place(Coder& coder, std::uint64_t mask,
                           std::uint64_t starts, std::int32_t x,
                           const Column& column, bool ink) {
    if ((mask & column.bit) != 0 && mask != column.bit) {
      entropy::Counter& counter =
          flags_[kSameFlags + (ink ? 8 : 0) + age_level(column)];
      const bool same =
          coder.code(std::bit_floor(starts) == column.bit, counter.p1());
      counter.update(same);
      if (same) return column.bit;
      mask &= ~column.bit;
    }
    // Far starts keep their distances: to the last one in this row, else to
    // the last one in these columns.
    const std::int32_t gap = x - row_last_[ink ? 1 : 0];
    const bool row = gap < 128;
    const auto anchor = static_cast<unsigned>(
        row ? row_last_[ink ? 1 : 0] & 63 : std::countl_zero(column.bit) & 63);
    const std::size_t kind = !row ? 2 : gap < 64 ? 1 : 0;
    return code_index(coder, mask, std::bit_floor(starts), anchor,
                      &flags_[kPlaces + ((ink ? 3 : 0) + kind) * 64]);
  }
  [[nodiscard]] std::size_t age_level(const Column& column) const {
    return far_start_age(y_ - column.y);
  }

  /// One of the set bits of `mask`, by halves of the distance from `anchor`;
  /// `start` holds the right one.
  template <class Coder>
  static std::uint64_t code_index(Coder& coder, std::uint64_t mask,
                                  std::uint64_t start, unsigned anchor,
                                  entropy::Counter* places) {
    mask = std::rotl(mask, static_cast<int>(anchor));
    start = std::rotl(start, static_cast<int>(anchor));
    std::uint64_t range = ~std::uint64_t{0};
    std::size_t node = 1;
    for (unsigned half = 32; half > 0; half /= 2) {
      const std::uint64_t first = range & ~(range >> half);
      bool second = (mask & first) == 0;
      if (!second && (mask & range & ~first) != 0) {
        entropy::Counter& counter = places[node];
        const int all = ones(mask & range);
        const int later = ones(mask & range & ~first);
        if (counter.n == 0) {
          counter = {static_cast<std::uint16_t>(65536 * later / all), 12};
        }
        second = coder.code((start & first) == 0, counter.p1());
        counter.update(second);
      }
      range &= second ? ~first : first;
      node = node * 2 + (second ? 1 : 0);
    }
    return std::rotr(mask & range, static_cast<int>(anchor));
  }

  /// Finds what is known around the words from `word` - 1 on.
  void see(std::int32_t word);
  [[nodiscard]] bool is_quiet_span(std::int32_t word,
                                   const std::vector<std::uint64_t>& above);
  int predict_open(std::uint64_t mask, std::int32_t word, bool ink);
  [[nodiscard]] std::size_t group_context(std::uint64_t mask,
                                          std::uint64_t above, std::int32_t x,
                                          std::int32_t y) const;
  void predict_near(std::int32_t x, std::int32_t y, bool ink);
  int probability();
  void update_near(bool bit);

  const CrackMap& cracks_;
  std::array<entropy::Counter, kFlags> flags_;
  std::array<unsigned, 2> row_starts_{};  ///< open starts in this row
  std::array<unsigned, 2> recent_{};      ///< decayed over the rows
  std::array<std::vector<Column>, 2> columns_;
  FarFlagModel far_;
  std::int32_t y_ = 0;
  QuietSpanModel spans_;
  std::int32_t span_end_ = 0;  ///< of the span that has a start: a word
  bool span_found_ = false;    ///< and a word before this one has it
  /// The cracks known within two rows of the points of each word, as
  /// CrackMap::known_around() gives them, with a word of margin on either side.
  std::vector<std::uint64_t> known_;
  bool stale_ = false;
  std::array<std::int32_t, 2> row_last_{};
  unsigned row_near_ = 0;  ///< near starts in this row
  std::vector<entropy::Counter> near_;
  std::array<entropy::Counter*, kContexts> active_{};
  entropy::Mixer<8, 1> mixer_;
};

}  // namespace unstep::codec
