#pragma once

#include <array>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace unstep {

/// How many bits of a word are set. Not std::popcount: without an instruction
/// for it, which not all machines have, that is a call.
[[nodiscard]] constexpr int ones(std::uint64_t word) {
  word -= word >> 1 & 0x5555555555555555ULL;
  word = (word & 0x3333333333333333ULL) + (word >> 2 & 0x3333333333333333ULL);
  word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fULL;
  return static_cast<int>(word * 0x0101010101010101ULL >> 56);
}

#if defined(__SSE2__)

namespace detail {

inline __m128i load_two(const std::uint64_t* words) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(words));
}

/// The bits set in each nibble.
inline __m128i ones_of_nibbles(__m128i v) {
  v = _mm_sub_epi8(v, _mm_and_si128(_mm_srli_epi64(v, 1), _mm_set1_epi8(0x55)));
  const __m128i low = _mm_set1_epi8(0x33);
  return _mm_add_epi8(_mm_and_si128(v, low),
                      _mm_and_si128(_mm_srli_epi64(v, 2), low));
}

/// The sums of the nibbles, which may be up to 8, of either half.
inline std::array<int, 2> sums_of_nibbles(__m128i v) {
  const __m128i low = _mm_set1_epi8(0x0f);
  v = _mm_add_epi8(_mm_and_si128(v, low),
                   _mm_and_si128(_mm_srli_epi64(v, 4), low));
  v = _mm_sad_epu8(v, _mm_setzero_si128());
  return {_mm_cvtsi128_si32(v), _mm_extract_epi16(v, 4)};
}

}  // namespace detail

#endif

/// In how many bits each of two words differs from `other`.
[[nodiscard]] inline std::array<int, 2> ones_of_two(const std::uint64_t* words,
                                                    std::uint64_t other) {
#if defined(__SSE2__)
  const __m128i both = _mm_set1_epi64x(static_cast<long long>(other));
  return detail::sums_of_nibbles(
      detail::ones_of_nibbles(_mm_xor_si128(detail::load_two(words), both)));
#else
  return {ones(words[0] ^ other), ones(words[1] ^ other)};
#endif
}

/// In how many bits four words of a, moved right, differ from four of b.
[[nodiscard]] inline int ones_of_difference(const std::uint64_t* a, int move_a,
                                            const std::uint64_t* b,
                                            int move_b) {
#if defined(__SSE2__)
  const auto difference = [&](int i) {
    return _mm_xor_si128(
        _mm_srl_epi64(detail::load_two(a + i), _mm_cvtsi32_si128(move_a)),
        _mm_srl_epi64(detail::load_two(b + i), _mm_cvtsi32_si128(move_b)));
  };
  const auto [low, high] = detail::sums_of_nibbles(
      _mm_add_epi8(detail::ones_of_nibbles(difference(0)),
                   detail::ones_of_nibbles(difference(2))));
  return low + high;
#else
  int sum = 0;
  for (int i = 0; i < 4; ++i) sum += ones(a[i] >> move_a ^ b[i] >> move_b);
  return sum;
#endif
}

}  // namespace unstep
