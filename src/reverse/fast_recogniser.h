#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "reverse/segment_recogniser.h"

/// The longest digital straight segment at the head of steps in memory: the
/// same state as SegmentRecogniser's, faster.
///
/// Why it is fast:
/// - The first letters of a segment are one word of bits, looked up.
/// - Points i and i - w of a line have the same remainder, so letter i is
///   letter i - w until the line tilts or the segment ends: the segment is
///   compared with itself, sixteen letters at a time.
/// - At a letter that differs, let q be the point after it. The line's own
///   letter would lead to a remainder p in 0..w-1; s1 in place of s0 leads to
///   p - w, s0 in place of s1 to p + w. Only -1 and w keep the segment, so p
///   must be w - 1 or 0: a multiple of w after the first lower or upper leaning
///   point. Of these q - w is then the last, and no record of it is needed.
namespace unstep::reverse {

/// Letters that are looked up, and the letters that are read for it.
inline constexpr std::uint32_t kHeadLetters = 12;
inline constexpr std::uint32_t kHeadRead = 16;

/// The state after a few letters; SegmentState in eight bytes.
struct HeadState {
  std::uint8_t a = 0, w = 1, upper = 0, upper_ones = 0, lower = 0,
               lower_ones = 0;
};

struct HeadTable {
  /// [word]: how many of its letters are a segment. Bit i is letter i.
  std::array<std::uint8_t, 1U << kHeadLetters> length;
  /// [word of n letters + 2^n].
  std::array<HeadState, 2U << kHeadLetters> state;
};
extern const HeadTable kHeads;

/// Letter i in bits 8 i to 8 i + 7.
inline std::uint64_t load_letters(const Step* at) {
  std::uint64_t letters = 0;
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&letters, at, 8);
  } else {
    for (int i = 0; i < 8; ++i) letters |= std::uint64_t{at[i]} << (8 * i);
  }
  return letters;
}

/// Bit i: letter i of `letters`, all below 8, is not `step`.
inline std::uint32_t letters_other_than(Step step, std::uint64_t letters) {
  constexpr std::uint64_t kOnes = 0x0101010101010101;
  const std::uint64_t other = letters ^ kOnes * step;
  const std::uint64_t bits = (other | other >> 1 | other >> 2) & kOnes;
  return static_cast<std::uint32_t>(bits * 0x0102040810204080 >> 56);
}

/// How many of the letters s[0..count) equal those `lag` before them.
inline std::uint32_t equal_letters(const Step* s, std::uint32_t lag,
                                   std::uint32_t count) {
  std::uint32_t i = 0;
  const Step* before = s - lag;
#if defined(__SSE2__)
  for (; count - i >= 16; i += 16) {
    const unsigned equal =
        static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(
            _mm_loadu_si128(reinterpret_cast<const __m128i*>(s + i)),
            _mm_loadu_si128(reinterpret_cast<const __m128i*>(before + i)))));
    if (equal != 0xFFFF)
      return i + static_cast<std::uint32_t>(std::countr_one(equal));
  }
#else
  for (; count - i >= 16; i += 16) {
    const std::uint64_t low = load_letters(s + i) ^ load_letters(before + i);
    const std::uint64_t high =
        load_letters(s + i + 8) ^ load_letters(before + i + 8);
    if ((low | high) == 0) continue;
    if (low != 0)
      return i + static_cast<std::uint32_t>(std::countr_zero(low)) / 8;
    return i + 8 + static_cast<std::uint32_t>(std::countr_zero(high)) / 8;
  }
#endif
  while (i < count && s[i] == before[i]) ++i;
  return i;
}

class FastRecogniser {
 public:
  explicit FastRecogniser(Connectivity connectivity)
      : connectivity_(connectivity) {}

  /// REQUIRES: steps is not empty, and every step fits the connectivity.
  [[nodiscard]] SegmentState longest(std::span<const Step> steps) const {
    const Step* s = steps.data();
    const auto m = static_cast<std::uint32_t>(
        std::min<std::size_t>(steps.size(), kMaxSegment));
    if (m < kHeadRead) return by_letters(s, m);
    SegmentState state;
    if (!head(s, state)) compare(s, m, state);
    return state;
  }

 private:
  [[nodiscard]] SegmentState by_letters(const Step* s, std::uint32_t m) const {
    SegmentRecogniser recogniser(connectivity_);
    for (std::uint32_t i = 0; i < m && recogniser.push(s[i]);) ++i;
    return recogniser.state();
  }

  /// The first letters. True if the segment ends within them.
  bool head(const Step* s, SegmentState& state) const {
    constexpr std::uint32_t kAll = (1U << kHeadLetters) - 1;
    state.s0 = state.s1 = s[0];
    const std::uint64_t low = load_letters(s);
    const std::uint64_t high = load_letters(s + 8);
    const std::uint32_t word =
        letters_other_than(s[0], low) | letters_other_than(s[0], high) << 8;
    if ((word & kAll) == 0) {
      state.n = kHeadLetters;
      return false;
    }
    const auto first = static_cast<std::uint32_t>(std::countr_zero(word));
    const Step s1 = s[first];
    if (!are_neighbours(s[0], s1, connectivity_)) {
      state.n = first;
      return true;
    }
    const std::uint32_t foreign = word & (letters_other_than(s1, low) |
                                          letters_other_than(s1, high) << 8);
    const auto native = static_cast<std::uint32_t>(
        std::countr_zero(foreign | 1U << kHeadLetters));
    const std::uint32_t n =
        std::min<std::uint32_t>(kHeads.length[word & kAll], native);
    const HeadState& known = kHeads.state[(1U << n) | (word & ((1U << n) - 1))];
    state = {s[0],
             s1,
             n,
             known.a,
             known.w,
             {known.upper, known.upper_ones},
             {known.lower, known.lower_ones}};
    return n < kHeadLetters;
  }

  void compare(const Step* s, std::uint32_t m, SegmentState& state) const {
    std::uint32_t n = state.n;
    for (;;) {
      n += equal_letters(s + n, state.w, m - n);
      if (n == m) break;
      const Step letter = s[n];
      if (letter != state.s0 && letter != state.s1) {
        if (state.s1 != state.s0) break;
        if (!are_neighbours(state.s0, letter, connectivity_)) break;
        state.s1 = letter;
      }
      const bool kept = letter != state.s0
                            ? tilt<1>(n + 1, state.lower, state.upper, state)
                            : tilt<-1>(n + 1, state.upper, state.lower, state);
      if (!kept) break;
      ++n;
    }
    state.n = n;
  }

  /// Point q, above (side 1) or below (-1) the line, tilts it about `far`;
  /// q - w becomes the first leaning point of the other kind, `near`.
  template <int side>
  static bool tilt(std::uint32_t q, WordPoint& near, const WordPoint& far,
                   SegmentState& state) {
    const std::uint32_t periods = (q - near.index) / state.w;
    if (periods * state.w != q - near.index) return false;
    near.ones += (periods - 1) * state.a;
    near.index = q - state.w;
    state.a += near.ones + static_cast<std::uint32_t>(side) - far.ones;
    state.w = q - far.index;
    return true;
  }

  Connectivity connectivity_;
};

}  // namespace unstep::reverse
