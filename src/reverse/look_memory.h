#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reverse/chain_walk.h"

namespace unstep::reverse {

/// What looks along 4-connected chains found, by the steps that they saw: the
/// same steps, turned by quarters, give the same lines, and drawings have few
/// short words. For one tolerance and one axis.
///
/// A look is remembered with all steps that it saw, at most kSteps; it is
/// found by the first of them. The last that came stays.
class LookMemory {
 public:
  static constexpr std::size_t kSteps = 32;

  /// What a look found: numbers of steps and the chain's points after them,
  /// relative to where it looked from.
  struct Found {
    std::size_t farthest_after = 0;
    std::size_t before_after = 0;
    Point farthest;
    Point before;
  };

  /// `steps`: of all chains together, to choose the size: about 4 bytes for
  /// each, from 4 KiB to 256 KiB.
  explicit LookMemory(std::size_t steps);

  /// Prepares the looks along a chain. Of an 8-connected one nothing is
  /// remembered.
  void begin(const ChainWalk& chain);

  /// The next kSteps steps from `index` on. REQUIRES: index < size() of the
  /// chain.
  [[nodiscard]] std::uint64_t word_at(std::size_t index) const {
    const std::size_t bit = 2 * (index % kSteps);
    const std::uint64_t* const word = words_.data() + index / kSteps;
    return word[0] >> bit | word[1] << 1 << (63 - bit);
  }

  /// What a look that sees this word finds, if one is remembered that saw less
  /// than `limit` steps and the one after them.
  [[nodiscard]] std::optional<Found> find(std::uint64_t word,
                                          std::size_t limit) const {
    const std::uint64_t turned = turn_to_first(word);
    const Entry& entry = entries_[place_of(turned)];
    if ((turned ^ entry.word) << entry.unseen_bits != 0 ||
        entry.seen >= limit) {
      return std::nullopt;
    }
    return Found{entry.farthest_after, entry.before_after,
                 from_frame(word, entry.farthest_x, entry.farthest_y),
                 from_frame(word, entry.before_x, entry.before_y)};
  }

  /// Remembers what a look found that saw `seen` steps, less than kSteps, and
  /// the one after them.
  void keep(std::uint64_t word, std::size_t seen, const Found& found);

  [[nodiscard]] bool in_use() const { return !words_.empty(); }

 private:
  /// Points in a frame whose first axis is the first step, the second a quarter
  /// turn on by the codes.
  struct Entry {
    std::uint64_t word = 1;  ///< of no look: the first step is turned to 0
    std::uint8_t unseen_bits = 0;
    std::uint8_t seen = 0;
    std::uint8_t farthest_after = 0;
    std::uint8_t before_after = 0;
    std::int8_t farthest_x = 0;
    std::int8_t farthest_y = 0;
    std::int8_t before_x = 0;
    std::int8_t before_y = 0;
  };

  static constexpr std::uint64_t kLow = 0x5555555555555555U;
  static constexpr std::uint64_t kHigh = ~kLow;
  /// Steps that say where a look is.
  static constexpr int kPlaceSteps = 12;

  /// The first step subtracted from all, each modulo 4.
  static std::uint64_t turn_to_first(std::uint64_t word) {
    const std::uint64_t first = (word & 3) * kLow;
    return ((word | kHigh) - (first & kLow)) ^ ((word ^ ~first) & kHigh);
  }

  [[nodiscard]] std::size_t place_of(std::uint64_t turned) const {
    const std::uint64_t head = turned << (64 - 2 * kPlaceSteps);
    return static_cast<std::size_t>(head * 0x9E3779B97F4A7C15U >> shift_);
  }

  [[nodiscard]] Point from_frame(std::uint64_t word, std::int32_t x,
                                 std::int32_t y) const {
    const Point first = quarters_[word & 3];
    const Point second = quarters_[(word + 1) & 3];
    return {x * first.x + y * second.x, x * first.y + y * second.y};
  }

  std::vector<Entry> entries_;
  int shift_;
  std::vector<std::uint64_t> words_;  ///< 2 bits a step
  std::array<Point, 4> quarters_;
};

}  // namespace unstep::reverse
