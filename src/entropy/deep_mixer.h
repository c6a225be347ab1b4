#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "entropy/logistic.h"
#include "entropy/table_memory.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace unstep::entropy {

/// Sums of products and weight updates over n int16 inputs and int32 weights
/// with 20 fractional bits. Sums wrap modulo 2^32, so the SSE2 form and the
/// portable one (the reference) give the same bits always.
/// REQUIRES: n is a multiple of 8; |x[i]| <= 4095.
namespace deep_mixing {

/// The upper bits of a weight: 14 fractional ones, kept within int16.
[[nodiscard]] constexpr std::int32_t narrowed(std::int32_t w) {
  return std::clamp(w >> 6, -32768, 32767);
}

inline std::int32_t dot_reference(const std::int16_t* x, const std::int32_t* w,
                                  std::size_t n) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += static_cast<std::uint32_t>(x[i] * narrowed(w[i]));
  }
  return static_cast<std::int32_t>(sum);
}

inline void train_reference(const std::int16_t* x, std::int32_t* w,
                            std::size_t n, std::int16_t error) {
  for (std::size_t i = 0; i < n; ++i) {
    w[i] = static_cast<std::int32_t>(
        static_cast<std::uint32_t>(w[i]) +
        static_cast<std::uint32_t>((x[i] * error + 128) >> 8));
  }
}

#if defined(__SSE2__)

inline std::int32_t dot(const std::int16_t* x, const std::int32_t* w,
                        std::size_t n) {
  __m128i sum = _mm_setzero_si128();
  for (std::size_t i = 0; i < n; i += 8) {
    const auto* at = reinterpret_cast<const __m128i*>(w + i);
    const __m128i narrow =
        _mm_packs_epi32(_mm_srai_epi32(_mm_loadu_si128(at), 6),
                        _mm_srai_epi32(_mm_loadu_si128(at + 1), 6));
    sum = _mm_add_epi32(
        sum,
        _mm_madd_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(x + i)),
                       narrow));
  }
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0x4e));
  sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0xb1));
  return _mm_cvtsi128_si32(sum);
}

inline void train(const std::int16_t* x, std::int32_t* w, std::size_t n,
                  std::int16_t error) {
  const __m128i e = _mm_set1_epi16(error);
  const __m128i half = _mm_set1_epi32(128);
  const auto add = [&](std::int32_t* to, __m128i product) {
    auto* at = reinterpret_cast<__m128i*>(to);
    const __m128i change = _mm_srai_epi32(_mm_add_epi32(product, half), 8);
    _mm_storeu_si128(at, _mm_add_epi32(_mm_loadu_si128(at), change));
  };
  for (std::size_t i = 0; i < n; i += 8) {
    const __m128i inputs =
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(x + i));
    const __m128i low = _mm_mullo_epi16(inputs, e);
    const __m128i high = _mm_mulhi_epi16(inputs, e);
    add(w + i, _mm_unpacklo_epi16(low, high));
    add(w + i + 4, _mm_unpackhi_epi16(low, high));
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

}  // namespace deep_mixing

/// A network of two layers: kSets weight vectors, each picked by its own
/// selector and trained on its own error, as in Mixer; then one more vector
/// that weighs what they say, picked and trained likewise. For models that have
/// time: weights are finer and rates lower than in Mixer.
template <std::size_t kInputs, std::size_t kSets>
class DeepMixer {
  static_assert(kInputs % 8 == 0);

 public:
  using Inputs = std::array<std::int16_t, kInputs>;
  using Chosen = std::array<std::size_t, kSets>;

  /// `selectors[s]`: how many vectors set s chooses from; `finals`: how many
  /// the last layer does. `initial` has 12 fractional bits; vector k starts
  /// with initial[k % initial.size()]. REQUIRES: initial is not empty.
  DeepMixer(const Chosen& selectors, std::size_t finals,
            std::span<const Inputs> initial)
      : initial_(initial.begin(), initial.end()),
        finals_(finals * kSets, kOne / static_cast<std::int32_t>(kSets)) {
    for (std::size_t s = 0; s < kSets; ++s) {
      weights_[s] = make_table<std::int32_t>(selectors[s] * kInputs);
      ages_[s].resize(selectors[s]);
      begun_[s].resize(selectors[s]);
    }
  }

  /// Vector `number`, counted through the sets, begins with these weights, 12
  /// fractional bits, instead, as if it had seen `age` bits.
  void begin(std::size_t number, const Inputs& weights, std::uint16_t age) {
    std::size_t s = 0;
    for (; number >= ages_[s].size(); ++s) number -= ages_[s].size();
    begin(s, number, weights);
    ages_[s][number] = age;
  }

  /// What was learned, for training a warm start: vector k of set s, 20
  /// fractional bits, zeros if it has never been chosen, and how many bits each
  /// has seen.
  [[nodiscard]] std::span<const std::int32_t> weights(std::size_t s,
                                                      std::size_t k) const {
    return {vector(s, k), kInputs};
  }
  [[nodiscard]] std::span<const std::uint16_t> ages(std::size_t s) const {
    return ages_[s];
  }

  static std::uint64_t memory(const Chosen& selectors) {
    std::uint64_t vectors = 0;
    for (const std::size_t n : selectors) vectors += n;
    return vectors *
           (kInputs * sizeof(std::int32_t) + sizeof(std::uint16_t) + 1);
  }

  /// The inputs of the next prediction, stretches; unused ones stay 0.
  [[nodiscard]] Inputs& inputs() { return inputs_; }

  /// Predicts under the chosen vectors; returns a stretch.
  int mix(const Chosen& chosen, std::size_t last) {
    chosen_ = chosen;
    last_ = last * kSets;
    std::int64_t sum = 0;
    for (std::size_t s = 0; s < kSets; ++s) {
      // Most vectors of a small drawing are never chosen.
      if (begun_[s][chosen[s]] == 0)
        begin(s, chosen[s], initial_[chosen[s] % initial_.size()]);
      outputs_[s] = clamp_stretch(
          deep_mixing::dot(inputs_.data(), vector(s, chosen[s]), kInputs) >>
          14);
      sum += std::int64_t{outputs_[s]} * finals_[last_ + s];
    }
    // Below 3071 * 2^23 * 2^5 by kMost.
    output_ = static_cast<int>(
        std::clamp<std::int64_t>(sum >> 20, -kStretchMax, kStretchMax));
    return output_;
  }

  /// Learns from the coded bit.
  void update(bool bit) {
    const int truth = bit ? 65536 : 0;
    for (std::size_t s = 0; s < kSets; ++s) {
      const int error = truth - squash(outputs_[s]);
      if (error < kSpared && error > -kSpared) continue;
      std::uint16_t& age = ages_[s][chosen_[s]];
      const int rate =
          kRateEnd + (kRateStart - kRateEnd) * 16 / (16 + age / 64);
      if (age < 60000) ++age;
      // 65536 * 700 >> 12 fits int16.
      deep_mixing::train(inputs_.data(), vector(s, chosen_[s]), kInputs,
                         static_cast<std::int16_t>((error * rate) >> 12));
    }
    const int error = truth - squash(output_);
    for (std::size_t s = 0; s < kSets; ++s) {
      const auto change = static_cast<std::int32_t>(
          (std::int64_t{outputs_[s]} * error * kFinalRate) >> 20);
      std::int32_t& w = finals_[last_ + s];
      w = std::clamp(w + change, -kMost, kMost);
    }
  }

  static constexpr int kRateStart = 700;  ///< 0.011
  static constexpr int kRateEnd = 130;    ///< 0.002
  static constexpr int kFinalRate = 60;
  static constexpr int kSpared = 200;  ///< smaller errors teach nothing

 private:
  static constexpr std::int32_t kOne = 1 << 20;
  static constexpr std::int32_t kMost = 1 << 23;

  [[nodiscard]] std::int32_t* vector(std::size_t s, std::size_t k) const {
    return weights_[s].get() + k * kInputs;
  }
  /// `weights` have 12 fractional bits.
  void begin(std::size_t s, std::size_t k, const Inputs& weights) {
    std::transform(weights.begin(), weights.end(), vector(s, k),
                   [](std::int16_t w) { return w * (kOne >> 12); });
    begun_[s][k] = 1;
  }
  static int clamp_stretch(int x) {
    return std::clamp(x, -kStretchMax, kStretchMax);
  }

  alignas(16) Inputs inputs_{};
  Chosen chosen_{};
  std::array<int, kSets> outputs_{};
  std::size_t last_ = 0;
  int output_ = 0;
  std::vector<Inputs> initial_;
  std::array<Table<std::int32_t>, kSets> weights_;
  std::array<std::vector<std::uint16_t>, kSets> ages_;
  std::array<std::vector<std::uint8_t>, kSets> begun_;
  std::vector<std::int32_t> finals_;
};

}  // namespace unstep::entropy
