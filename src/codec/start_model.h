#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/crack_map.h"
#include "entropy/counter.h"
#include "entropy/mixer.h"

namespace unstep::codec {

/// Predicts where contours start. The scan visits 64 grid points of a row at a
/// time. Far from known cracks, one flag says whether a start is among the
/// candidates and a uniform index says where; near known cracks each candidate
/// has its own flag under the cracks around it.
class StartModel {
 public:
  explicit StartModel(const CrackMap& cracks);

  /// Candidate starts among the 64 points of `word` in row y.
  struct Candidates {
    std::uint64_t near = 0;               ///< beside known cracks, not likely
    std::uint64_t likely = 0;             ///< near ones under thin ink
    std::array<std::uint64_t, 2> open{};  ///< far, on paper and on ink
  };
  /// `above`: the pixels of row y - 1 at these points.
  [[nodiscard]] Candidates candidates(std::int32_t y, std::int32_t word,
                                      std::uint64_t above,
                                      std::uint64_t used) const;

  void begin_row();

  /// Whether one of the open candidates `mask` (not 0) is a start, and which:
  /// returns its bit or 0. `starts`: the true starts (encoder only).
  template <class Coder>
  std::uint64_t code_open(Coder& coder, std::uint64_t mask, bool ink,
                          std::uint64_t starts) {
    entropy::Counter& counter = flags_[open_context(mask, ink)];
    const bool any = coder.code((starts & mask) != 0, counter.p1_fine());
    counter.update(any);
    if (!any) return 0;
    note_start(ink);
    return code_index(coder, mask, starts & mask);
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
  static constexpr std::size_t kOpenFlags = 2 * 4 * 4 * 4;
  static constexpr std::size_t kFlags = kOpenFlags + 8 * 5 * 3 * 2;

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
  /// One of the set bits of `mask`, uniformly; `starts` holds the first.
  template <class Coder>
  static std::uint64_t code_index(Coder& coder, std::uint64_t mask,
                                  std::uint64_t starts) {
    // Halve the candidate set until one is left: p = share of the upper part.
    while (std::popcount(mask) > 1) {
      const int count = std::popcount(mask);
      std::uint64_t upper = mask;
      for (int i = 0; i < count - count / 2; ++i) upper &= upper - 1;
      // upper now holds the count / 2 highest (first) candidates.
      const bool first =
          coder.code((starts & upper) != 0, 65536 * (count / 2) / count);
      mask = first ? upper : mask & ~upper;
    }
    return mask;
  }

  [[nodiscard]] std::size_t open_context(std::uint64_t mask, bool ink) const;
  void note_start(bool ink);
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
  unsigned row_near_ = 0;                 ///< near starts in this row
  std::vector<entropy::Counter> near_;
  std::array<entropy::Counter*, kContexts> active_{};
  entropy::Mixer<8, 1> mixer_;
};

}  // namespace unstep::codec
