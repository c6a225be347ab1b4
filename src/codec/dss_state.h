#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace unstep::codec {

/// A running digital-straight-segment recogniser over a walk: the reverse
/// interpolator used as a predictor. Greedy: a step that no straight line can
/// explain closes the segment and opens the next. Steps are directions of a
/// ring of 4 or 8; the two letters of a segment are neighbours on the ring.
///
/// Works on the two-letter word of the segment (directions s0 and s1). The
/// line has A steps s1 in W = A + B steps; r is the remainder of the current
/// point, 0..W-1 inside (Debled-Rennesson and Reveilles, 1995). All numbers
/// stay below the segment's length, which is capped at kMaxLength so that
/// products fit int64.
class DssState {
 public:
  static constexpr std::int64_t kMaxLength = 1 << 30;

  /// `ring`: 4 or 8, for 4- or 8-connected walks.
  explicit DssState(int ring = 4) : ring_(ring) {}

  void reset() { *this = DssState(ring_); }
  void push(int step);

  /// Which of the two letters would keep the segment, and the segment's age:
  /// 0..1023.
  [[nodiscard]] unsigned verdict(int last) const;
  /// The slope as (W, A) while W < 64, else coarse.
  [[nodiscard]] std::uint32_t slope() const;
  [[nodiscard]] std::uint32_t remainder() const {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(r_, 0, 255));
  }
  /// The length of the segment before this one, capped at 255.
  [[nodiscard]] std::uint32_t previous_length() const {
    return static_cast<std::uint32_t>(std::min<std::int64_t>(previous_, 255));
  }

 private:
  void start(int step);

  int ring_;
  int s0_ = -1;
  int s1_ = -1;
  std::int64_t x_ = 0, y_ = 0;  // counts of s0 and s1 so far
  std::int64_t a_ = 0, b_ = 1, w_ = 1, r_ = 0;
  // First and last leaning points: upper (r = 0) and lower (r = W - 1).
  std::int64_t xu_ = 0, yu_ = 0, xl_ = 0, yl_ = 0;
  std::int64_t lux_ = 0, luy_ = 0, llx_ = 0, lly_ = 0;
  std::int64_t length_ = 0;
  std::int64_t previous_ = 0;
};

}  // namespace unstep::codec
