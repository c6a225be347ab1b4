#pragma once

#include <algorithm>
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

/// Sums of products and weight updates over n int16 inputs. Weights are int16
/// with 14 fractional bits. Sums wrap modulo 2^32 and weights stay within
/// int16 in both forms, so the SSE2 form and the portable one (the reference)
/// give the same bits always.
/// REQUIRES: n is a multiple of 8; |x[i]| <= 4095.
namespace mixing {

inline std::int32_t dot_reference(const std::int16_t* x, const std::int16_t* w,
                                  std::size_t n) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += static_cast<std::uint32_t>(x[i] * w[i]);
  }
  return static_cast<std::int32_t>(sum);
}

inline void train_reference(const std::int16_t* x, std::int16_t* w,
                            std::size_t n, std::int16_t error) {
  for (std::size_t i = 0; i < n; ++i) {
    const int change = ((x[i] * 8 * error >> 16) + 1) >> 1;
    w[i] = static_cast<std::int16_t>(std::clamp(w[i] + change, -32768, 32767));
  }
}

#if defined(__SSE2__)

template <std::size_t n>
inline std::int32_t dot(const std::int16_t* x, const std::int16_t* w) {
  __m128i sum = _mm_setzero_si128();
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; i += 8) {
    sum = _mm_add_epi32(
        sum, _mm_madd_epi16(
                 _mm_loadu_si128(reinterpret_cast<const __m128i*>(x + i)),
                 _mm_loadu_si128(reinterpret_cast<const __m128i*>(w + i))));
  }
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4e));
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0xb1));
  return _mm_cvtsi128_si32(sum);
}

template <std::size_t n>
inline void train(const std::int16_t* x, std::int16_t* w, std::int16_t error) {
  const __m128i e16 = _mm_set1_epi16(error);
  const __m128i one = _mm_set1_epi16(1);
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; i += 8) {
    auto* wp = reinterpret_cast<__m128i*>(w + i);
    const __m128i x16 = _mm_slli_epi16(
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(x + i)), 3);
    const __m128i change =
        _mm_srai_epi16(_mm_add_epi16(_mm_mulhi_epi16(x16, e16), one), 1);
    _mm_storeu_si128(wp, _mm_adds_epi16(_mm_loadu_si128(wp), change));
  }
}

#else

template <std::size_t n>
inline std::int32_t dot(const std::int16_t* x, const std::int16_t* w) {
  return dot_reference(x, w, n);
}

template <std::size_t n>
inline void train(const std::int16_t* x, std::int16_t* w, std::int16_t error) {
  train_reference(x, w, n, error);
}

#endif

}  // namespace mixing

namespace detail {

/// rate = learning rate * 2^16, by how often a vector has learned / 64.
constexpr std::array<std::int16_t, 938> make_mixer_rates(int start, int end) {
  std::array<std::int16_t, 938> rates{};
  for (int k = 0; k < 938; ++k) {
    rates[static_cast<std::size_t>(k)] =
        static_cast<std::int16_t>(end + (start - end) * 16 / (16 + k));
  }
  return rates;
}

}  // namespace detail

/// Gated logistic mixing (M. Mahoney, PAQ; C. Mattern 2016): kSets weight
/// vectors, each picked by its own selector and trained on its own error; the
/// prediction is the mean of their outputs in the logistic domain.
///
/// kLanes predictions can be open at once, so that learning may be put off
/// until memory that was asked for has arrived. Lanes that are open together
/// must not pick the same vectors.
///
/// A vector learns nothing from an error below kSpared / 65536. Where most
/// decisions are nearly certain this keeps the rates up for those that are not.
template <std::size_t kInputs, std::size_t kSets, std::size_t kLanes = 1,
          int kSpared = 0>
class Mixer {
  static_assert(kInputs % 8 == 0);

 public:
  using Inputs = std::array<std::int16_t, kInputs>;

  /// `selectors[s]`: how many vectors set s chooses from. `initial`: the
  /// weights that vector k starts with are initial[k % initial.size()], with
  /// 12 fractional bits. REQUIRES: initial is not empty.
  Mixer(const std::array<std::size_t, kSets>& selectors,
        std::span<const std::array<std::int16_t, kInputs>> initial) {
    std::vector<Inputs> scaled;
    for (const Inputs& vector : initial) scaled.push_back(scale(vector));
    for (std::size_t s = 0; s < kSets; ++s) {
      weights_[s].reserve(selectors[s] * kInputs);
      for (std::size_t k = 0; k < selectors[s]; ++k) {
        const Inputs& vector = scaled[k % scaled.size()];
        weights_[s].insert(weights_[s].end(), vector.begin(), vector.end());
      }
      ages_[s].resize(selectors[s]);
    }
  }

  /// What was learned, for training a warm start: vector k of set s, 14
  /// fractional bits, and how many bits it has seen.
  [[nodiscard]] std::span<const std::int16_t> weights(std::size_t s,
                                                      std::size_t k) const {
    return {weights_[s].data() + k * kInputs, kInputs};
  }
  [[nodiscard]] std::span<const std::uint16_t> ages(std::size_t s) const {
    return ages_[s];
  }

  /// Vector `number`, counted through the sets, begins with these weights, 12
  /// fractional bits, instead.
  void begin(std::size_t number, const Inputs& weights) {
    std::size_t s = 0;
    for (; number >= ages_[s].size(); ++s) number -= ages_[s].size();
    set_weights(s, number, scale(weights), 0);
  }

  /// For a warm start: vector k of set s, 14 fractional bits, as if it had seen
  /// `age` bits.
  void set_weights(std::size_t s, std::size_t k, const Inputs& weights,
                   std::uint16_t age) {
    std::copy(weights.begin(), weights.end(),
              weights_[s].begin() + static_cast<std::ptrdiff_t>(k * kInputs));
    ages_[s][k] = age;
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
      const std::int32_t sum = mixing::dot<kInputs>(
          l.inputs.data(), weights_[s].data() + chosen[s] * kInputs);
      l.outputs[s] = clamp_stretch(sum >> 14);
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
      if (error < kSpared && error > -kSpared) continue;
      // 65536 * 2047 fits int32, the result int16 (< 65536 * 2047 / 4096).
      const int rate = kRates[age / 64];
      if (age < 60000) ++age;
      mixing::train<kInputs>(l.inputs.data(),
                             weights_[s].data() + l.chosen[s] * kInputs,
                             static_cast<std::int16_t>((error * rate) >> 12));
    }
  }

  static constexpr int kRateStart = 1400;  ///< 0.021
  static constexpr int kRateEnd = 350;     ///< 0.005
  static constexpr auto kRates = detail::make_mixer_rates(kRateStart, kRateEnd);

 private:
  /// From 12 to 14 fractional bits.
  static Inputs scale(Inputs weights) {
    for (std::int16_t& w : weights) {
      w = static_cast<std::int16_t>(std::clamp(w * 4, -32768, 32767));
    }
    return weights;
  }
  static int clamp_stretch(int x) {
    return x > kStretchMax ? kStretchMax : x < -kStretchMax ? -kStretchMax : x;
  }

  struct Lane {
    alignas(16) Inputs inputs{};
    std::array<std::size_t, kSets> chosen{};
    std::array<int, kSets> outputs{};
  };
  std::array<Lane, kLanes> lanes_;
  std::array<std::vector<std::int16_t>, kSets> weights_;
  std::array<std::vector<std::uint16_t>, kSets> ages_;
};

}  // namespace unstep::entropy
