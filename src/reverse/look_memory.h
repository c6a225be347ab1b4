#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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

  /// A look that goes on after all but the last of head_steps() steps: what it
  /// found so far, where it is, the square of the greatest distance and the
  /// sides of its cone as NearDirections has them.
  struct Begun {
    Found found;
    Point at;
    std::int32_t farthest2 = 0;
    std::uint16_t left = 0;
    std::uint16_t right = 0;
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

  /// Points in a frame whose first axis is the first step, the second a quarter
  /// turn on by the codes.
  struct Ends {
    std::uint8_t farthest_after = 0;
    std::uint8_t before_after = 0;
    std::int8_t farthest_x = 0;
    std::int8_t farthest_y = 0;
    std::int8_t before_x = 0;
    std::int8_t before_y = 0;
  };
  [[nodiscard]] Found found(const Ends& ends, std::uint64_t word) const {
    return {ends.farthest_after, ends.before_after,
            from_frame(word, ends.farthest_x, ends.farthest_y),
            from_frame(word, ends.before_x, ends.before_y)};
  }

  /// What a look that sees this word finds, if one is remembered that saw less
  /// than `limit` steps and the one after them; else nullptr.
  [[nodiscard]] const Ends* find(std::uint64_t word, std::size_t limit) const {
    const std::uint64_t turned = turn_to_first(word);
    const Entry& entry = entries_[place_of(turned)];
    if ((turned ^ entry.word) << entry.unseen_bits != 0 || entry.seen >= limit)
      return nullptr;
    return &entry.ends;
  }

  /// Remembers what a look found that saw `seen` steps, less than kSteps, and
  /// the one after them.
  void keep(std::uint64_t word, std::size_t seen, const Found& found);

  /// How looks begin that see the same first steps. Holds of those whose limit
  /// is head_steps() steps away or farther.
  class Head {
   public:
    [[nodiscard]] bool is_known() const { return kind_ != kUnknown; }
    [[nodiscard]] bool is_done() const { return kind_ == kDone; }
    [[nodiscard]] const Ends& ends() const { return ends_; }

   private:
    friend class LookMemory;
    enum Kind : std::uint8_t { kUnknown, kGoesOn, kDone };
    Kind kind_ = kUnknown;
    std::uint8_t farthest2_ = 0;
    Ends ends_;
    std::uint16_t left_ = 0;
    std::uint16_t right_ = 0;
    std::int8_t at_x_ = 0;
    std::int8_t at_y_ = 0;
  };
  [[nodiscard]] std::size_t head_steps() const { return head_steps_; }
  [[nodiscard]] const Head& head(std::uint64_t word) const {
    return heads_[head_of(word)];
  }
  /// REQUIRES: it is known and not done.
  [[nodiscard]] Begun begun(const Head& head, std::uint64_t word) const {
    const std::uint16_t turn = quarters_of(word);
    return {found(head.ends_, word), from_frame(word, head.at_x_, head.at_y_),
            head.farthest2_, static_cast<std::uint16_t>(head.left_ + turn),
            static_cast<std::uint16_t>(head.right_ + turn)};
  }
  void keep_done(std::uint64_t word, const Found& found);
  void keep_begun(std::uint64_t word, const Begun& begun);

  [[nodiscard]] bool in_use() const { return !words_.empty(); }

 private:
  struct Entry {
    std::uint64_t word = 1;  ///< of no look: the first step is turned to 0
    std::uint8_t unseen_bits = 0;
    std::uint8_t seen = 0;
    Ends ends;
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

  [[nodiscard]] Ends into_frame(std::uint64_t word, const Found& found) const;
  [[nodiscard]] Point from_frame(std::uint64_t word, std::int32_t x,
                                 std::int32_t y) const {
    const Point first = quarters_[word & 3];
    const Point second = quarters_[(word + 1) & 3];
    return {x * first.x + y * second.x, x * first.y + y * second.y};
  }

  [[nodiscard]] std::size_t head_of(std::uint64_t word) const {
    return static_cast<std::size_t>(turn_to_first(word) >> 2) &
           (heads_.size() - 1);
  }
  /// How far the frame is turned, as a direction of NearDirections.
  [[nodiscard]] std::uint16_t quarters_of(std::uint64_t word) const {
    return static_cast<std::uint16_t>(static_cast<unsigned>(word & 3) *
                                      quarter_);
  }

  std::vector<Entry> entries_;
  int shift_;
  std::vector<Head> heads_;
  std::size_t head_steps_;
  unsigned quarter_ = 0;              ///< of the codes, as a direction
  std::vector<std::uint64_t> words_;  ///< 2 bits a step
  std::array<Point, 4> quarters_;
};

}  // namespace unstep::reverse
