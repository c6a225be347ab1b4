#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/number_model.h"
#include "entropy/counter.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// Predicts the digital straight segments of chains that are coded by these.
///
/// Range: n and w are at most 2^32 - 1, else the segment is outside.
class SegmentModel {
 public:
  /// `before`: the last step of the chain, 0 at first. Returns what was coded;
  /// of a segment that is not outside the invariant of DigitalSegment holds,
  /// and its first step is s0.
  template <class Coder>
  DigitalSegment code(Coder& coder, const DigitalSegment& truth, Step before,
                      bool four) {
    DigitalSegment s;
    s.s0 = code_first(coder, truth.s0, before);
    const unsigned side = four ? 2 : 1;
    outside_ = four && (s.s0 & 1) != 0;
    const bool mixed = NumberModel::decide(coder, mixed_, truth.s1 != truth.s0);
    std::size_t kind = 0;
    s.s1 = s.s0;
    if (mixed) {
      const bool left = NumberModel::decide(
          coder, left_, ((truth.s1 - truth.s0) & 7U) == side);
      s.s1 = static_cast<Step>((s.s0 + (left ? side : 8 - side)) & 7U);
      kind = left ? 2 : 1;
    }
    s.n = narrow(lengths_[kind].code(coder, std::uint64_t{truth.n} - 1) + 1);
    if (!mixed) return s;
    s.w = narrow(widths_[kind - 1].code(coder, std::uint64_t{truth.w} - 2) + 2);
    outside_ = outside_ || s.w > s.n;
    if (outside_) return s;
    s.a = 1 + code_below(coder, s.w - 1, truth.a - 1);
    if (outside_) return s;
    s.r = code_below(coder, s.w - s.a, truth.r);
    return s;
  }

  /// Whether the last segment cannot be.
  [[nodiscard]] bool outside() const { return outside_; }

 private:
  std::uint32_t narrow(std::uint64_t value) {
    outside_ = outside_ || value > 0xffffffffU;
    return static_cast<std::uint32_t>(value);
  }

  template <class Coder>
  Step code_first(Coder& coder, Step truth, Step before) {
    const auto turn = static_cast<unsigned>(truth - before) & 7U;
    std::size_t node = 1;
    for (int bit = 2; bit >= 0; --bit) {
      const bool one =
          NumberModel::decide(coder, turns_[node], (turn >> bit & 1) != 0);
      node = node << 1 | (one ? 1U : 0U);
    }
    return static_cast<Step>((before + node) & 7U);
  }

  /// A number below `count` >= 1, all alike.
  template <class Coder>
  std::uint32_t code_below(Coder& coder, std::uint32_t count,
                           std::uint32_t truth) {
    std::uint32_t value = 0;
    for (int bit = static_cast<int>(std::bit_width(count - 1)) - 1; bit >= 0;
         --bit) {
      const bool one = coder.code((truth >> bit & 1) != 0, 32768);
      value = value << 1 | (one ? 1U : 0U);
    }
    outside_ = outside_ || value >= count;
    return value;
  }

  std::array<entropy::Counter, 8> turns_;
  entropy::Counter mixed_;
  entropy::Counter left_;
  std::array<NumberModel, 3> lengths_;  ///< of one letter, to the right, left
  std::array<NumberModel, 2> widths_;
  bool outside_ = false;
};

/// Where a segment's steps lead from `at`, y up. Steps of neighbouring codes go
/// one way on each axis, so all of them are between. a * n < 2^64.
[[nodiscard]] inline Point end_of(const DigitalSegment& s, Point at,
                                  bool& inside) {
  const auto second =
      static_cast<std::int64_t>((std::uint64_t{s.a} * s.n + s.r) / s.w);
  const std::int64_t first = std::int64_t{s.n} - second;
  const Point u = step_delta(s.s0);
  const Point v = step_delta(s.s1);
  const std::int64_t x = at.x + first * u.x + second * v.x;
  const std::int64_t y = at.y + first * u.y + second * v.y;
  inside =
      x >= -kMaxCoord && x <= kMaxCoord && y >= -kMaxCoord && y <= kMaxCoord;
  return inside
             ? Point{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}
             : at;
}

/// The last step of a segment: s1 if the count of s1 grows with it.
[[nodiscard]] inline Step last_step(const DigitalSegment& s) {
  const auto count = [&s](std::uint64_t n) { return (s.a * n + s.r) / s.w; };
  return count(s.n) > count(s.n - 1) ? s.s1 : s.s0;
}

}  // namespace unstep::codec
