#pragma once

#include <cstdint>
#include <limits>

#include "unstep/grid.h"

/// Recognition of digital straight segments step by step (I. Debled-Rennesson
/// and J.-P. Reveilles, "A linear algorithm for segmentation of digital
/// curves", 1995), on the word of two letters that the steps of a segment
/// make.
///
/// Point i of a word comes after i letters; y(i) of them were s1. A line of
/// slope a / w draws the word if its remainder a i + r - w y(i) stays in
/// 0..w-1. Points with remainder 0 are upper, those with w - 1 lower leaning
/// points. A letter that leads to -1 or w tilts the line about a leaning point;
/// one that leads further has no line.
namespace unstep::reverse {

/// A point of the word: its index and its y.
struct WordPoint {
  std::uint32_t index = 0;
  std::uint32_t ones = 0;
  friend bool operator==(const WordPoint&, const WordPoint&) = default;
};

/// What is known of the open segment: its line and the first leaning points.
/// INVARIANT with n >= 1: gcd(a, w) = 1, w <= n, y(i) = floor((a i + r) / w).
struct SegmentState {
  Step s0 = 0;
  Step s1 = 0;
  std::uint32_t n = 0;
  std::uint32_t a = 0;
  std::uint32_t w = 1;
  WordPoint upper;
  WordPoint lower;

  /// The remainder of point 0 follows from that of the first upper leaning
  /// point, which is 0. Both products are below 2^64, the difference is in
  /// 0..w-1.
  [[nodiscard]] constexpr DigitalSegment segment() const {
    const std::uint64_t r =
        std::uint64_t{w} * upper.ones - std::uint64_t{a} * upper.index;
    return {s0, s1, n, a, w, static_cast<std::uint32_t>(r)};
  }
  friend bool operator==(const SegmentState&, const SegmentState&) = default;
};

/// The longest segment; a chain that is straighter is split.
inline constexpr std::uint32_t kMaxSegment =
    std::numeric_limits<std::uint32_t>::max();

[[nodiscard]] constexpr bool fits(Step step, Connectivity connectivity) {
  return step <= 7 && (connectivity == Connectivity::eight || step % 2 == 0);
}

[[nodiscard]] constexpr bool are_neighbours(Step a, Step b,
                                            Connectivity connectivity) {
  const int apart = (a - b) & 7;
  const int least = connectivity == Connectivity::eight ? 1 : 2;
  return apart == least || apart == 8 - least;
}

/// The reference: one letter at a time, constant time and memory.
///
/// Range: indices, counts, a and w are at most n < 2^32; the remainder is in
/// -1..w, so that next in push() is within +-2^33.
class SegmentRecogniser {
 public:
  constexpr explicit SegmentRecogniser(Connectivity connectivity)
      : connectivity_(connectivity) {}

  /// Goes on from a state whose last leaning points are these, for tests at
  /// the limit.
  constexpr SegmentRecogniser(Connectivity connectivity,
                              const SegmentState& state, WordPoint last_upper,
                              WordPoint last_lower, std::uint32_t ones)
      : connectivity_(connectivity),
        state_(state),
        last_upper_(last_upper),
        last_lower_(last_lower),
        ones_(ones),
        remainder_(static_cast<std::int64_t>(std::uint64_t{state.a} * state.n +
                                             state.segment().r -
                                             std::uint64_t{state.w} * ones)) {}

  /// Takes the step if the segment stays one. REQUIRES: fits(step).
  constexpr bool push(Step step) {
    if (state_.n == 0) {
      state_.s0 = state_.s1 = step;
      state_.n = 1;
      last_upper_ = last_lower_ = {1, 0};
      return true;
    }
    if (state_.n == kMaxSegment) return false;
    const bool one = step != state_.s0;
    if (one && step != state_.s1) {
      if (state_.s1 != state_.s0) return false;
      if (!are_neighbours(state_.s0, step, connectivity_)) return false;
      state_.s1 = step;
    }
    return extend(one);
  }

  [[nodiscard]] constexpr const SegmentState& state() const { return state_; }

 private:
  constexpr bool extend(bool one) {
    const std::int64_t w = state_.w;
    const std::int64_t next = remainder_ + state_.a - (one ? w : 0);
    if (next < -1 || next > w) return false;
    ++state_.n;
    ones_ += one ? 1 : 0;
    const WordPoint point{state_.n, ones_};
    if (next == -1) {
      tilt(state_.upper, point);
      last_upper_ = point;
      state_.lower = last_lower_;
      remainder_ = 0;
    } else if (next == w) {
      tilt(state_.lower, point);
      last_lower_ = point;
      state_.upper = last_upper_;
      remainder_ = std::int64_t{state_.w} - 1;
    } else {
      if (next == 0) last_upper_ = point;
      if (next == w - 1) last_lower_ = point;
      remainder_ = next;
    }
    return true;
  }

  /// The slope from `from` to `to`.
  constexpr void tilt(WordPoint from, WordPoint to) {
    state_.a = to.ones - from.ones;
    state_.w = to.index - from.index;
  }

  Connectivity connectivity_;
  SegmentState state_;
  WordPoint last_upper_;
  WordPoint last_lower_;
  std::uint32_t ones_ = 0;
  std::int64_t remainder_ = 0;
};

}  // namespace unstep::reverse
