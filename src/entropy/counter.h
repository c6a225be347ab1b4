#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "entropy/logistic.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace unstep::entropy {

namespace detail {

/// 65536 / (n + 1.6): how far observation n + 1 moves a probability.
constexpr std::array<std::uint16_t, 256> make_rates() {
  std::array<std::uint16_t, 256> rates{};
  for (unsigned n = 0; n < 256; ++n) {
    rates[n] = static_cast<std::uint16_t>(655360U / (10 * n + 16));
  }
  return rates;
}

inline constexpr auto kRates = make_rates();

}  // namespace detail

/// Moves a probability towards an observed bit by rate / 65536 of the way and
/// one more, so that certainty is reached in the end. The same for both bits.
[[nodiscard]] constexpr std::uint16_t moved(std::uint16_t p, bool bit,
                                            std::uint16_t rate) {
  const std::uint16_t flip = bit ? 0xffff : 0;
  auto miss = static_cast<std::uint16_t>(p ^ flip);
  miss =
      static_cast<std::uint16_t>(miss - ((std::uint32_t{miss} * rate) >> 16));
  miss = static_cast<std::uint16_t>(miss - (miss != 0 ? 1 : 0));
  return static_cast<std::uint16_t>(miss ^ flip);
}

/// moved() on many probabilities at once; the SSE2 form gives the same bits.
/// REQUIRES: a multiple of 8.
template <std::size_t n>
inline void move_all(std::array<std::uint16_t, n>& p,
                     const std::array<std::uint16_t, n>& rate, bool bit) {
  static_assert(n % 8 == 0);
#if defined(__SSE2__)
  const __m128i flip = _mm_set1_epi16(bit ? -1 : 0);
  const __m128i one = _mm_set1_epi16(1);
  for (std::size_t i = 0; i < n; i += 8) {
    auto* at = reinterpret_cast<__m128i*>(p.data() + i);
    const __m128i rates =
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(rate.data() + i));
    __m128i miss = _mm_xor_si128(_mm_loadu_si128(at), flip);
    miss = _mm_sub_epi16(miss, _mm_mulhi_epu16(miss, rates));
    miss = _mm_subs_epu16(miss, one);
    _mm_storeu_si128(at, _mm_xor_si128(miss, flip));
  }
#else
  for (std::size_t i = 0; i < n; ++i) p[i] = moved(p[i], bit, rate[i]);
#endif
}

/// (p - 1/2) * trust / 65536 for many probabilities at once.
template <std::size_t n>
inline void lean_all(const std::array<std::uint16_t, n>& p,
                     const std::array<std::int16_t, n>& trust,
                     std::int16_t* out) {
  static_assert(n % 8 == 0);
#if defined(__SSE2__)
  const __m128i half = _mm_set1_epi16(-32768);
  for (std::size_t i = 0; i < n; i += 8) {
    const __m128i centred = _mm_xor_si128(
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(p.data() + i)), half);
    const __m128i weight =
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(trust.data() + i));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out + i),
                     _mm_mulhi_epi16(centred, weight));
  }
#else
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = static_cast<std::int16_t>(((p[i] - 32768) * trust[i]) >> 16);
  }
#endif
}

/// An adaptive probability with its own age: the first observations move it
/// fast, later ones as 1 / (n + 1.6), down to 1 / (kLimit + 1.6).
struct Counter {
  static constexpr int kLimit = 255;

  std::uint16_t p = 32768;  ///< of 65536 that the next bit is 1
  std::uint8_t n = 0;       ///< observations, saturating at kLimit

  void update(bool bit) {
    p = moved(p, bit, detail::kRates[n]);
    if (n < kLimit) ++n;
  }

  /// The probability, kept off the ends so that it can be coded with.
  [[nodiscard]] int p1() const { return std::clamp<int>(p, 16, 65520); }
  /// The same for events so rare that 1 / 4096 would be dear.
  [[nodiscard]] int p1_fine() const { return std::clamp<int>(p, 2, 65534); }
};

}  // namespace unstep::entropy
