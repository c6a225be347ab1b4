#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "entropy/logistic.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace unstep::entropy {

/// Sums of products and weight updates over N int16 inputs. Weights are int32
/// with 24 fractional bits; the product uses their upper 16 bits (12
/// fractional). Sums wrap modulo 2^32 in both forms, so the SSE2 form and the
/// portable one (the reference) give the same bits always.
/// REQUIRES: n is a multiple of 8.
namespace mixing {

inline std::int32_t dot_reference(const std::int16_t* x, const std::int32_t* w,
                                  std::size_t n) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t w16 = w[i] >> 12;
    w16 = w16 > 32767 ? 32767 : w16 < -32768 ? -32768 : w16;
    sum += static_cast<std::uint32_t>(x[i] * w16);
  }
  return static_cast<std::int32_t>(sum);
}

inline void train_reference(const std::int16_t* x, std::int32_t* w,
                            std::size_t n, std::int16_t error) {
  for (std::size_t i = 0; i < n; ++i) {
    w[i] = static_cast<std::int32_t>(
        static_cast<std::uint32_t>(w[i]) +
        static_cast<std::uint32_t>((x[i] * error) >> 4));
  }
}

#if defined(__SSE2__)

inline std::int32_t dot(const std::int16_t* x, const std::int32_t* w,
                        std::size_t n) {
  __m128i sum = _mm_setzero_si128();
  for (std::size_t i = 0; i < n; i += 8) {
    const auto* wp = reinterpret_cast<const __m128i*>(w + i);
    const __m128i w16 =
        _mm_packs_epi32(_mm_srai_epi32(_mm_loadu_si128(wp), 12),
                        _mm_srai_epi32(_mm_loadu_si128(wp + 1), 12));
    const __m128i x16 =
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(x + i));
    sum = _mm_add_epi32(sum, _mm_madd_epi16(x16, w16));
  }
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4e));
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0xb1));
  return _mm_cvtsi128_si32(sum);
}

inline void train(const std::int16_t* x, std::int32_t* w, std::size_t n,
                  std::int16_t error) {
  const __m128i e16 = _mm_set1_epi16(error);
  for (std::size_t i = 0; i < n; i += 8) {
    auto* wp = reinterpret_cast<__m128i*>(w + i);
    const __m128i x16 =
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(x + i));
    const __m128i low = _mm_mullo_epi16(x16, e16);
    const __m128i high = _mm_mulhi_epi16(x16, e16);
    const __m128i d0 = _mm_srai_epi32(_mm_unpacklo_epi16(low, high), 4);
    const __m128i d1 = _mm_srai_epi32(_mm_unpackhi_epi16(low, high), 4);
    _mm_storeu_si128(wp, _mm_add_epi32(_mm_loadu_si128(wp), d0));
    _mm_storeu_si128(wp + 1, _mm_add_epi32(_mm_loadu_si128(wp + 1), d1));
  }
}

#else

inline std::int32_t dot(const std::int16_t* x, const std::int32_t* w,
                        std::size_t n) {
  return dot_reference(x, w, n);
}

inline void train(const std::int16_t* x, std::int32_t* w, std::size_t n,
                  std::int16_t error) {
  train_reference(x, w, n, error);
}

#endif

}  // namespace mixing

/// Gated logistic mixing (M. Mahoney, PAQ; C. Mattern 2016): kSets weight
/// vectors, each picked by its own selector and trained on its own error; the
/// prediction is the mean of their outputs in the logistic domain.
///
/// kLanes predictions can be open at once, so that learning may be put off
/// until memory that was asked for has arrived. Lanes that are open together
/// must not pick the same vectors.
template <std::size_t kInputs, std::size_t kSets, std::size_t kLanes = 1>
class Mixer {
  static_assert(kInputs % 8 == 0);

 public:
  using Inputs = std::array<std::int16_t, kInputs>;

  /// `selectors[s]`: how many vectors set s chooses from. `initial`: the
  /// weights that vector k starts with are initial[k % initial.size()], with
  /// 12 fractional bits. REQUIRES: initial is not empty.
  Mixer(const std::array<std::size_t, kSets>& selectors,
        std::span<const std::array<std::int16_t, kInputs>> initial) {
    for (std::size_t s = 0; s < kSets; ++s) {
      weights_[s].reserve(selectors[s] * kInputs);
      for (std::size_t k = 0; k < selectors[s]; ++k) {
        for (const std::int16_t w : initial[k % initial.size()]) {
          weights_[s].push_back(w * 4096);
        }
      }
      ages_[s].resize(selectors[s]);
    }
  }

  /// What was learned, for training a warm start: vector k of set s, 24
  /// fractional bits, and how many bits it has seen.
  [[nodiscard]] std::span<const std::int32_t> weights(std::size_t s,
                                                      std::size_t k) const {
    return {weights_[s].data() + k * kInputs, kInputs};
  }
  [[nodiscard]] std::span<const std::uint16_t> ages(std::size_t s) const {
    return ages_[s];
  }

  /// The inputs of the next prediction, stretches; unused ones stay 0.
  [[nodiscard]] Inputs& inputs(std::size_t lane = 0) {
    return lanes_[lane].inputs;
  }

  /// Predicts under the chosen vectors; returns a stretch.
  int mix(const std::array<std::size_t, kSets>& chosen, std::size_t lane = 0) {
    Lane& l = lanes_[lane];
    l.chosen = chosen;
    std::int32_t total = 0;
    for (std::size_t s = 0; s < kSets; ++s) {
      const std::int32_t sum = mixing::dot(
          l.inputs.data(), weights_[s].data() + chosen[s] * kInputs, kInputs);
      l.outputs[s] = clamp_stretch(sum >> 12);
      total += l.outputs[s];
    }
    return total / static_cast<int>(kSets);
  }

  /// Learns from the coded bit.
  void update(bool bit, std::size_t lane = 0) {
    Lane& l = lanes_[lane];
    for (std::size_t s = 0; s < kSets; ++s) {
      std::uint16_t& age = ages_[s][l.chosen[s]];
      const int error = (bit ? 65536 : 0) - squash(l.outputs[s]);
      // rate = learning rate * 2^16; 65536 * 2047 fits int32, the result
      // int16 (< 65536 * 2047 / 4096 = 32752).
      const int rate = kRateEnd + (kRateStart - kRateEnd) * 1024 / (1024 + age);
      if (age < 60000) ++age;
      mixing::train(l.inputs.data(), weights_[s].data() + l.chosen[s] * kInputs,
                    kInputs, static_cast<std::int16_t>((error * rate) >> 12));
    }
  }

  static constexpr int kRateStart = 1800;  ///< 0.027
  static constexpr int kRateEnd = 350;     ///< 0.005

 private:
  static int clamp_stretch(int x) {
    return x > kStretchMax ? kStretchMax : x < -kStretchMax ? -kStretchMax : x;
  }

  struct Lane {
    alignas(16) Inputs inputs{};
    std::array<std::size_t, kSets> chosen{};
    std::array<int, kSets> outputs{};
  };
  std::array<Lane, kLanes> lanes_;
  std::array<std::vector<std::int32_t>, kSets> weights_;
  std::array<std::vector<std::uint16_t>, kSets> ages_;
};

}  // namespace unstep::entropy
