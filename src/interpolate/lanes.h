#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "unstep/grid.h"

/// Sixteen neighbouring remainders of a digital straight segment, (a i + r) mod
/// w, side by side; a block is their sixteen steps.
///
/// Range: remainders are 0..w - 1, and -w..w - 1 before they are corrected, so
/// w must be below 2^15, 2^31, 2^63 for lanes of 16, 32, 64 bits.
namespace unstep::interpolation {

inline constexpr std::size_t kBlock = 16;

/// What is the same for all steps of a segment.
template <class Lane>
struct LaneRule {
  explicit LaneRule(const DigitalSegment& s)
      : w(static_cast<Lane>(s.w)),
        first_one(static_cast<Lane>(s.w - s.a)),
        s0(s.s0),
        change(static_cast<Step>(s.s0 ^ s.s1)) {}

  Lane w;
  Lane first_one;    ///< the least remainder of a step s1
  Lane advance = 0;  ///< 16 a mod w - w
  Step s0;
  Step change;
};

/// The first sixteen remainders, and rule.advance.
template <class Lane>
std::array<Lane, kBlock> first_remainders(const DigitalSegment& s,
                                          LaneRule<Lane>& rule) {
  std::array<Lane, kBlock> remainders;
  std::uint64_t remainder = s.r;
  for (Lane& lane : remainders) {
    lane = static_cast<Lane>(remainder);
    remainder += s.a;
    if (remainder >= s.w) remainder -= s.w;
  }
  const std::uint64_t advance = kBlock * std::uint64_t{s.a} % s.w;
  rule.advance = static_cast<Lane>(static_cast<std::int64_t>(advance) - s.w);
  return remainders;
}

/// Any lane, any processor.
template <class Lane>
class Lanes {
 public:
  Lanes(const DigitalSegment& s, LaneRule<Lane>& rule)
      : lanes_(first_remainders(s, rule)) {}

  /// Writes sixteen steps.
  void draw(const LaneRule<Lane>& rule, Step* out) const {
    for (std::size_t i = 0; i < kBlock; ++i) {
      const bool one = lanes_[i] >= rule.first_one;
      out[i] = static_cast<Step>(rule.s0 ^ (one ? rule.change : 0));
    }
  }

  void advance(const LaneRule<Lane>& rule) {
    for (Lane& lane : lanes_) {
      const auto next = static_cast<Lane>(lane + rule.advance);
      lane = static_cast<Lane>(next + (next < 0 ? rule.w : 0));
    }
  }

 private:
  std::array<Lane, kBlock> lanes_;
};

/// 1 / w in 16 bits, rounded up. Quotients of numerators up to 16 w are exact
/// for w <= 64: the product is too large by at most 16 w (w - 1) < 2^16. [0]
/// and [1] are not used.
inline constexpr std::uint32_t kSmall = 64;
inline constexpr auto kReciprocals = [] {
  std::array<std::uint16_t, kSmall + 1> table{};
  for (std::uint32_t w = 2; w <= kSmall; ++w)
    table[w] = static_cast<std::uint16_t>((65536 + w - 1) / w);
  return table;
}();

/// t mod w. REQUIRES: 2 <= w <= kSmall, t <= 16 w.
inline std::uint32_t small_remainder(std::uint32_t t, std::uint32_t w) {
  return t - (t * kReciprocals[w] >> 16) * w;
}

#if defined(__SSE2__)

inline __m128i load_lanes(const void* at) {
  return _mm_loadu_si128(static_cast<const __m128i*>(at));
}

/// The same in registers of SSE2.
template <>
class Lanes<std::int16_t> {
 public:
  using Rule = LaneRule<std::int16_t>;

  Lanes(const DigitalSegment& s, Rule& rule) {
    if (s.w <= kSmall) {
      start_small(s, rule);
      return;
    }
    const auto remainders = first_remainders(s, rule);
    low_ = load_lanes(&remainders[0]);
    high_ = load_lanes(&remainders[8]);
  }

  void draw(const Rule& rule, Step* out) const {
    const __m128i limit =
        _mm_set1_epi16(static_cast<std::int16_t>(rule.first_one - 1));
    const __m128i ones = _mm_packs_epi16(_mm_cmpgt_epi16(low_, limit),
                                         _mm_cmpgt_epi16(high_, limit));
    const __m128i change =
        _mm_and_si128(ones, _mm_set1_epi8(static_cast<char>(rule.change)));
    _mm_storeu_si128(
        reinterpret_cast<__m128i*>(out),
        _mm_xor_si128(change, _mm_set1_epi8(static_cast<char>(rule.s0))));
  }

  void advance(const Rule& rule) {
    low_ = advanced(low_, rule);
    high_ = advanced(high_, rule);
  }

 private:
  void start_small(const DigitalSegment& s, Rule& rule) {
    const auto word = [](std::uint32_t v) {
      return _mm_set1_epi16(static_cast<std::int16_t>(v));
    };
    const __m128i a = word(s.a);
    const __m128i r = word(s.r);
    const __m128i w = word(s.w);
    const __m128i reciprocal = word(kReciprocals[s.w]);
    const auto remainders = [&](__m128i i) {
      const __m128i sum = _mm_add_epi16(_mm_mullo_epi16(i, a), r);
      const __m128i whole = _mm_mulhi_epu16(sum, reciprocal);
      return _mm_sub_epi16(sum, _mm_mullo_epi16(whole, w));
    };
    rule.advance = static_cast<std::int16_t>(
        static_cast<std::int32_t>(small_remainder(kBlock * s.a, s.w)) - rule.w);
    low_ = remainders(_mm_setr_epi16(0, 1, 2, 3, 4, 5, 6, 7));
    high_ = remainders(_mm_setr_epi16(8, 9, 10, 11, 12, 13, 14, 15));
  }

  static __m128i advanced(__m128i lanes, const Rule& rule) {
    const __m128i next = _mm_add_epi16(lanes, _mm_set1_epi16(rule.advance));
    return _mm_add_epi16(
        next, _mm_and_si128(_mm_srai_epi16(next, 15), _mm_set1_epi16(rule.w)));
  }

  __m128i low_;
  __m128i high_;
};

template <>
class Lanes<std::int32_t> {
 public:
  using Rule = LaneRule<std::int32_t>;

  Lanes(const DigitalSegment& s, Rule& rule) {
    const auto remainders = first_remainders(s, rule);
    for (std::size_t i = 0; i < 4; ++i)
      quarter_[i] = load_lanes(&remainders[4 * i]);
  }

  void draw(const Rule& rule, Step* out) const {
    const __m128i limit = _mm_set1_epi32(rule.first_one - 1);
    const auto ones = [&](std::size_t i) {
      return _mm_packs_epi32(_mm_cmpgt_epi32(quarter_[i], limit),
                             _mm_cmpgt_epi32(quarter_[i + 1], limit));
    };
    const __m128i change =
        _mm_and_si128(_mm_packs_epi16(ones(0), ones(2)),
                      _mm_set1_epi8(static_cast<char>(rule.change)));
    _mm_storeu_si128(
        reinterpret_cast<__m128i*>(out),
        _mm_xor_si128(change, _mm_set1_epi8(static_cast<char>(rule.s0))));
  }

  void advance(const Rule& rule) {
    for (__m128i& lanes : quarter_) {
      const __m128i next = _mm_add_epi32(lanes, _mm_set1_epi32(rule.advance));
      lanes = _mm_add_epi32(next, _mm_and_si128(_mm_srai_epi32(next, 31),
                                                _mm_set1_epi32(rule.w)));
    }
  }

 private:
  __m128i quarter_[4];
};

#endif

}  // namespace unstep::interpolation
