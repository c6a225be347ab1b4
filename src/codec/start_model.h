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
    std::uint64_t near = 0;               ///< beside known cracks
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
    entropy::Counter& counter = open_[open_context(mask, ink)];
    const bool any = coder.code((starts & mask) != 0, counter.p1_fine());
    counter.update(any);
    if (!any) return 0;
    note_start(ink);
    return code_index(coder, mask, starts & mask);
  }

  /// Whether the candidate at (x, y) is a start.
  template <class Coder>
  bool code_near(Coder& coder, std::int32_t x, std::int32_t y, bool ink,
                 bool start) {
    entropy::Counter& gate = tight(x, y, ink);
    if (gate.p < kRare && gate.n >= kRareAge) {
      const bool bit = coder.code(start, gate.p + 2);
      gate.update(bit);
      return bit;
    }
    predict_near(x, y, ink);
    const bool bit = coder.code(start, probability());
    update_near(bit);
    return bit;
  }

  static constexpr std::size_t kContexts = 3;

  /// log2 of a context's counters: the first is indexed by the cracks
  /// themselves, the others by a hash.
  static constexpr int near_bits(std::size_t context) {
    return context == 0 ? 16 : 14;
  }
  static constexpr std::size_t near_first(std::size_t context) {
    return context == 0 ? 0 : (std::size_t{1} << 16) + ((context - 1) << 14);
  }

  /// What was learned, for training a warm start.
  [[nodiscard]] std::span<const entropy::Counter> open() const { return open_; }
  [[nodiscard]] std::span<const entropy::Counter> near(
      std::size_t context) const {
    return {near_.data() + near_first(context),
            std::size_t{1} << near_bits(context)};
  }
  [[nodiscard]] const auto& mixer() const { return mixer_; }

 private:
  /// Below this of 65536 the tight context alone is used: 4 flags of 5.
  static constexpr int kRare = 100;
  static constexpr int kRareAge = 16;  ///< observations before it may

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
  entropy::Counter& tight(std::int32_t x, std::int32_t y, bool ink);
  void predict_near(std::int32_t x, std::int32_t y, bool ink);
  int probability();
  void update_near(bool bit);

  const CrackMap& cracks_;
  std::array<entropy::Counter, 2 * 4 * 4 * 4> open_;
  std::array<unsigned, 2> row_starts_{};  ///< open starts in this row
  std::array<unsigned, 2> recent_{};      ///< decayed over the rows
  std::uint64_t row_ = 0, north_ = 0, south_ = 0, above_ = 0, below_ = 0;
  std::vector<entropy::Counter> near_;
  std::array<entropy::Counter*, kContexts> active_{};
  entropy::Mixer<8, 1> mixer_;
};

}  // namespace unstep::codec
