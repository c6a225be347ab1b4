#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "codec/context.h"
#include "codec/warm_start.h"
#include "entropy/counter.h"
#include "entropy/logistic.h"
#include "entropy/mixer.h"
#include "entropy/refiner.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace unstep::codec {

/// Codes decisions, of pixels above all, under eight hashed contexts, mixed by
/// two sets of weights; what the mixer says is refined by what followed where
/// it said the same under the same vector of the first set. A DecisionModel
/// that checks its slots and is made for vector code.
class PixelMixer {
 public:
  static constexpr std::size_t kContexts = 8;
  static constexpr std::size_t kInputs = 2 * kContexts;
  static constexpr std::size_t kSets = 2;
  using Contexts = std::array<std::uint64_t, kContexts>;
  using Chosen = std::array<std::size_t, kSets>;
  using Weights = std::array<std::int16_t, kInputs>;
  using Mixer = entropy::Mixer<kInputs, kSets>;

  /// The weights to begin with, 12 fractional bits: those of all vectors, and
  /// the vectors that begin elsewhere (warm::for_each_vector).
  struct Start {
    Weights shared;
    std::string_view vectors;
  };
  static constexpr Start even() {
    Start start{};
    start.shared.fill(6144 / kContexts);
    return start;
  }

  /// 2^table_bits slots per context. REQUIRES: 8 <= table_bits <= 24.
  PixelMixer(int table_bits, const Chosen& selectors,
             const Start& start = even())
      : bits_(table_bits),
        slots_(kContexts << table_bits),
        mixer_(selectors, std::array<Weights, 1>{start.shared}),
        refiner_(selectors[0]) {
    warm::for_each_vector<kInputs>(
        start.vectors, [&](std::size_t) { return start.shared; },
        [&](std::size_t number, const Weights& weights) {
          mixer_.begin(number, weights);
        });
  }

  /// Bytes of the slots.
  static constexpr std::uint64_t memory(int table_bits) {
    return std::uint64_t{kContexts * sizeof(Slot)} << table_bits;
  }

  /// Where the slots of a decision are. Of each context there are two side by
  /// side, one for each value of the bit before: they can be found, and their
  /// memory asked for, while that bit is not known yet.
  struct Places {
    alignas(16) std::array<std::uint16_t, kContexts> checks{};
    std::array<std::uint32_t, kContexts> slots{};
  };
  void find(const Contexts& contexts, Places& places) const {
    for (std::size_t i = 0; i < kContexts; ++i) {
      const std::uint64_t hash = contexts[i] * kGolden;
      const std::uint64_t pair = hash >> (65 - bits_);
      places.slots[i] = static_cast<std::uint32_t>((i << bits_) + 2 * pair);
      places.checks[i] = static_cast<std::uint16_t>(hash >> 40 & 0xff);
      __builtin_prefetch(&slots_[places.slots[i]], 1);
    }
  }

  /// The places of a decision and, on their way, those of the next.
  class Ahead {
   public:
    /// The next decision is not the one after the last.
    void skip() { is_found_ = false; }

    /// Those of this decision. `find_this` and `find_next` find places: the
    /// first is called where the last decision did not find them.
    template <class FindThis, class FindNext>
    const Places& move_on(const FindThis& find_this,
                          const FindNext& find_next) {
      Places& here = places_[turn_];
      if (!is_found_) find_this(here);
      turn_ ^= 1U;
      find_next(places_[turn_]);
      is_found_ = true;
      return here;
    }

   private:
    std::array<Places, 2> places_;
    unsigned turn_ = 0;
    bool is_found_ = false;
  };

  template <class Coder>
  bool code(Coder& coder, bool bit, const Places& places, bool before,
            const Chosen& chosen) {
    recall(places, before);
    const int x = mixer_.mix(chosen);
    const int p = (entropy::squash(x) + refiner_.refine(x, chosen[0])) / 2;
    const bool coded = coder.code(bit, std::clamp(p, 24, 65512));
    refiner_.learn(coded);
    mixer_.update(coded);
    learn(coded);
    return coded;
  }

  /// For training a warm start.
  [[nodiscard]] const Mixer& mixer() const { return mixer_; }

 private:
  struct Slot {
    std::uint16_t p = 32768;
    std::uint8_t n = 0;
    std::uint8_t check = 0;
  };

  /// No step waits for what a slot holds, so that their memory arrives
  /// together.
  void recall(const Places& places, bool before) {
    for (std::size_t i = 0; i < kContexts; ++i) {
      active_[i] = &slots_[places.slots[i] + (before ? 1U : 0U)];
    }
    std::memcpy(checks_.data(), places.checks.data(), sizeof checks_);
    load();
    auto& inputs = mixer_.inputs();
    for (std::size_t i = 0; i < kContexts; ++i) {
      rates_[i] = entropy::detail::kRates[ages_[i]];
      trusts_[i] = kTrust[ages_[i]];
      inputs[i] = static_cast<std::int16_t>(entropy::stretch(p_[i]));
    }
    entropy::lean_all(p_, trusts_, inputs.data() + kContexts);
  }

  void learn(bool bit) {
    entropy::move_all(p_, rates_, bit);
    for (std::size_t i = 0; i < kContexts; ++i) {
      const auto age =
          static_cast<std::uint8_t>(ages_[i] + (ages_[i] < 255 ? 1 : 0));
      *active_[i] = {p_[i], age, static_cast<std::uint8_t>(checks_[i])};
    }
  }

#if defined(__SSE2__)

  /// Probabilities and ages of the slots; one whose check differs is new.
  void load() {
    const auto four = [this](std::size_t i) {
      const auto word = [this](std::size_t k) {
        return std::bit_cast<std::int32_t>(*active_[k]);
      };
      const __m128i slots =
          _mm_set_epi32(word(i + 3), word(i + 2), word(i + 1), word(i));
      // The four probabilities, then the four ages with their checks.
      return _mm_shuffle_epi32(
          _mm_shufflehi_epi16(_mm_shufflelo_epi16(slots, 0xd8), 0xd8), 0xd8);
    };
    const __m128i low = four(0);
    const __m128i high = four(4);
    const __m128i ages = _mm_unpackhi_epi64(low, high);
    const auto* checks = reinterpret_cast<const __m128i*>(checks_.data());
    const __m128i found =
        _mm_cmpeq_epi16(_mm_srli_epi16(ages, 8), _mm_load_si128(checks));
    const __m128i half = _mm_set1_epi16(-32768);
    _mm_store_si128(
        reinterpret_cast<__m128i*>(p_.data()),
        _mm_or_si128(_mm_and_si128(found, _mm_unpacklo_epi64(low, high)),
                     _mm_andnot_si128(found, half)));
    _mm_store_si128(
        reinterpret_cast<__m128i*>(ages_.data()),
        _mm_and_si128(found, _mm_and_si128(ages, _mm_set1_epi16(255))));
  }

#else

  void load() {
    for (std::size_t i = 0; i < kContexts; ++i) {
      const Slot slot = *active_[i];
      const bool found = slot.check == checks_[i];
      p_[i] = found ? slot.p : std::uint16_t{32768};
      ages_[i] = found ? slot.n : std::uint16_t{0};
    }
  }

#endif

  int bits_;
  std::vector<Slot> slots_;
  Mixer mixer_;
  entropy::Refiner refiner_;
  std::array<Slot*, kContexts> active_{};
  alignas(16) std::array<std::uint16_t, kContexts> checks_{};
  alignas(16) std::array<std::uint16_t, kContexts> ages_{};
  alignas(16) std::array<std::uint16_t, kContexts> p_{};
  alignas(16) std::array<std::uint16_t, kContexts> rates_{};
  alignas(16) std::array<std::int16_t, kContexts> trusts_{};
};

}  // namespace unstep::codec
