#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "entropy/counter.h"
#include "entropy/logistic.h"
#include "entropy/table_memory.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace unstep::entropy {

/// One context's memory in a hashed table: a counter for each of the two
/// binary decisions that make a symbol, and check bits of the hash.
struct Slot {
  std::array<std::uint16_t, 2> p{32768, 32768};
  std::array<std::uint8_t, 2> n{};
  std::uint16_t check = 0;
};
static_assert(sizeof(Slot) == 8);

/// Slots taken apart: the same field of all side by side, for vector code.
template <std::size_t kWidth>
struct SlotLanes {
  static_assert(kWidth % 8 == 0);
  static constexpr std::size_t kCount = kWidth;
  alignas(16) std::array<std::array<std::uint16_t, kCount>, 2> p{};
  alignas(16) std::array<std::uint16_t, kCount> n{};  ///< n[0] + 256 n[1]
  alignas(16) std::array<std::uint16_t, kCount> check{};

  /// Reads the slots; one whose check differs is new: p 1/2, n 0.
  void load(const std::array<Slot*, kCount>& slots);
  void store(const std::array<Slot*, kCount>& slots) const;
};

#if defined(__SSE2__)

namespace detail {

inline __m128i load_pair(const Slot* a, const Slot* b) {
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(a));
  return _mm_castps_si128(
      _mm_loadh_pi(_mm_castsi128_ps(low), reinterpret_cast<const __m64*>(b)));
}

inline void store_pair(Slot* a, Slot* b, __m128i pair) {
  _mm_storel_epi64(reinterpret_cast<__m128i*>(a), pair);
  _mm_storeh_pi(reinterpret_cast<__m64*>(b), _mm_castsi128_ps(pair));
}

}  // namespace detail

template <std::size_t kWidth>
inline void SlotLanes<kWidth>::load(const std::array<Slot*, kCount>& slots) {
  const __m128i half = _mm_set1_epi16(-32768);
  for (std::size_t i = 0; i < kCount; i += 8) {
    const auto at = [i](auto& lanes) {
      return reinterpret_cast<__m128i*>(lanes.data() + i);
    };
    const __m128i a = detail::load_pair(slots[i], slots[i + 1]);
    const __m128i b = detail::load_pair(slots[i + 2], slots[i + 3]);
    const __m128i c = detail::load_pair(slots[i + 4], slots[i + 5]);
    const __m128i d = detail::load_pair(slots[i + 6], slots[i + 7]);
    const __m128i ab0 = _mm_unpacklo_epi16(a, b);
    const __m128i ab1 = _mm_unpackhi_epi16(a, b);
    const __m128i cd0 = _mm_unpacklo_epi16(c, d);
    const __m128i cd1 = _mm_unpackhi_epi16(c, d);
    const __m128i ab_p = _mm_unpacklo_epi16(ab0, ab1);
    const __m128i ab_n = _mm_unpackhi_epi16(ab0, ab1);
    const __m128i cd_p = _mm_unpacklo_epi16(cd0, cd1);
    const __m128i cd_n = _mm_unpackhi_epi16(cd0, cd1);
    const __m128i found = _mm_cmpeq_epi16(_mm_unpackhi_epi64(ab_n, cd_n),
                                          _mm_load_si128(at(check)));
    const __m128i fresh = _mm_andnot_si128(found, half);
    _mm_store_si128(
        at(p[0]),
        _mm_or_si128(_mm_and_si128(found, _mm_unpacklo_epi64(ab_p, cd_p)),
                     fresh));
    _mm_store_si128(
        at(p[1]),
        _mm_or_si128(_mm_and_si128(found, _mm_unpackhi_epi64(ab_p, cd_p)),
                     fresh));
    _mm_store_si128(at(n),
                    _mm_and_si128(found, _mm_unpacklo_epi64(ab_n, cd_n)));
  }
}

template <std::size_t kWidth>
inline void SlotLanes<kWidth>::store(
    const std::array<Slot*, kCount>& slots) const {
  for (std::size_t i = 0; i < kCount; i += 8) {
    const auto at = [i](const auto& lanes) {
      return _mm_load_si128(reinterpret_cast<const __m128i*>(lanes.data() + i));
    };
    const __m128i p0 = at(p[0]);
    const __m128i p1 = at(p[1]);
    const __m128i ages = at(n);
    const __m128i checks = at(check);
    const __m128i p_low = _mm_unpacklo_epi16(p0, p1);
    const __m128i p_high = _mm_unpackhi_epi16(p0, p1);
    const __m128i n_low = _mm_unpacklo_epi16(ages, checks);
    const __m128i n_high = _mm_unpackhi_epi16(ages, checks);
    detail::store_pair(slots[i], slots[i + 1],
                       _mm_unpacklo_epi32(p_low, n_low));
    detail::store_pair(slots[i + 2], slots[i + 3],
                       _mm_unpackhi_epi32(p_low, n_low));
    detail::store_pair(slots[i + 4], slots[i + 5],
                       _mm_unpacklo_epi32(p_high, n_high));
    detail::store_pair(slots[i + 6], slots[i + 7],
                       _mm_unpackhi_epi32(p_high, n_high));
  }
}

#else

template <std::size_t kWidth>
inline void SlotLanes<kWidth>::load(const std::array<Slot*, kCount>& slots) {
  for (std::size_t i = 0; i < kCount; ++i) {
    const Slot slot = slots[i]->check == check[i] ? *slots[i] : Slot{};
    p[0][i] = slot.p[0];
    p[1][i] = slot.p[1];
    n[i] = static_cast<std::uint16_t>(slot.n[0] | slot.n[1] << 8);
  }
}

template <std::size_t kWidth>
inline void SlotLanes<kWidth>::store(
    const std::array<Slot*, kCount>& slots) const {
  for (std::size_t i = 0; i < kCount; ++i) {
    *slots[i] = {{p[0][i], p[1][i]},
                 {static_cast<std::uint8_t>(n[i] & 0xff),
                  static_cast<std::uint8_t>(n[i] >> 8)},
                 check[i]};
  }
}

#endif

/// The memory of kContexts hashed contexts of a symbol made of up to two binary
/// decisions. Per symbol: ask() for every context; learn() what became of
/// the symbol before; recall(); then predict() a decision, code it, note() it.
/// The order lets memory arrive while the last symbol is learned.
template <std::size_t kContexts>
class ContextSlots {
 public:
  static constexpr std::size_t kLanes = (kContexts + 7) / 8 * 8;
  /// Two inputs of a mixer for each lane; those of the unused lanes are 0.
  static constexpr std::size_t kInputs = 2 * kLanes;

  /// bits[i]: log2 of the slots of context i.
  explicit ContextSlots(const std::array<int, kContexts>& bits) {
    std::size_t size = 1;  // slot 0 is for the unused lanes
    for (std::size_t i = 0; i < kContexts; ++i) {
      shift_[i] = 64 - bits[i];
      first_[i] = size;
      size += std::size_t{1} << bits[i];
    }
    // Zeros are as good as new, since no hash has check 0.
    slots_ = make_table<Slot>(size);
    slots_[0] = Slot{};
    next_.fill(slots_.get());
    active_.fill(slots_.get());
  }
  ContextSlots(const ContextSlots&) = delete;
  ContextSlots& operator=(const ContextSlots&) = delete;

  /// 1..4096: the bits below those that find the slot of a 2^16 table.
  static std::uint16_t check_of(std::uint64_t hash) {
    return static_cast<std::uint16_t>((hash >> 36 & 0xfff) + 1);
  }

  [[nodiscard]] std::span<Slot> slots(std::size_t context) {
    return {slots_.get() + first_[context],
            std::size_t{1} << (64 - shift_[context])};
  }
  [[nodiscard]] std::span<const Slot> slots(std::size_t context) const {
    return {slots_.get() + first_[context],
            std::size_t{1} << (64 - shift_[context])};
  }

  /// The slot of context i for a hash of which the upper bits are good.
  void ask(std::size_t i, std::uint64_t hash) {
    Slot* slot = &slots_[first_[i] + (hash >> shift_[i])];
    __builtin_prefetch(slot, 1);
    next_[i] = slot;
    checks_[i] = check_of(hash);
  }

  void recall() {
    active_ = next_;
    lanes_.check = checks_;
    lanes_.load(active_);
  }

  /// Writes the inputs for decision `node` (0 or 1): stretches, and distances
  /// from one half that grow with the age. The inputs of unused lanes are 0.
  void predict(std::size_t node, std::int16_t* inputs) {
    const auto& p = lanes_.p[node];
#if defined(__SSE2__)
    for (std::size_t i = 0; i < kLanes; i += 8) {
      const auto at = [&](std::size_t k) {
        return i + k < kContexts ? static_cast<short>(stretch(p[i + k]))
                                 : short{0};
      };
      _mm_storeu_si128(reinterpret_cast<__m128i*>(inputs + i),
                       _mm_set_epi16(at(7), at(6), at(5), at(4), at(3), at(2),
                                     at(1), at(0)));
      __m128i n =
          _mm_load_si128(reinterpret_cast<const __m128i*>(lanes_.n.data() + i));
      n = node == 0 ? _mm_and_si128(n, _mm_set1_epi16(255))
                    : _mm_srli_epi16(n, 8);
      n = _mm_mullo_epi16(_mm_min_epi16(n, _mm_set1_epi16(kTrustAge)),
                          _mm_set1_epi16(kTrustStep));
      const __m128i lean = _mm_xor_si128(
          _mm_load_si128(reinterpret_cast<const __m128i*>(p.data() + i)),
          _mm_set1_epi16(-32768));
      const __m128i used =
          _mm_load_si128(reinterpret_cast<const __m128i*>(kUsed.data() + i));
      _mm_storeu_si128(reinterpret_cast<__m128i*>(inputs + kLanes + i),
                       _mm_and_si128(_mm_mulhi_epi16(lean, n), used));
    }
#else
    for (std::size_t i = 0; i < kLanes; ++i) {
      inputs[i] = static_cast<std::int16_t>(i < kContexts ? stretch(p[i]) : 0);
      const int n = lanes_.n[i] >> (node == 0 ? 0 : 8) & 0xff;
      inputs[kLanes + i] = static_cast<std::int16_t>(
          kUsed[i] &
          (p[i] - 32768) * (kTrustStep * std::min(n, kTrustAge)) >> 16);
    }
#endif
  }

  void note(std::size_t node, bool bit) { noted_[node] = bit ? 2 : 1; }

  /// Which decisions of the last symbol were noted: calls
  /// `each(node, bit)` for the mixer to learn them too.
  template <class Each>
  void learn(const Each& each) {
    if (noted_[0] + noted_[1] == 0) return;
    for (std::size_t node = 0; node < 2; ++node) {
      if (noted_[node] == 0) continue;
      const bool bit = noted_[node] == 2;
      noted_[node] = 0;
      each(node, bit);
      move(node, bit);
      grow(node);
    }
    lanes_.store(active_);
  }

 private:
  /// All ones in the lanes of contexts.
  alignas(16) static constexpr std::array<std::int16_t, kLanes> kUsed = [] {
    std::array<std::int16_t, kLanes> lanes{};
    for (std::size_t i = 0; i < kContexts; ++i) lanes[i] = -1;
    return lanes;
  }();

  static constexpr int kTrustAge = 30;
  static constexpr int kTrustStep = 51;  ///< 32768 * 30 * 51 >> 16 = 765

  /// The counters of all lanes learn a bit, as moved() says.
  void move(std::size_t node, bool bit) {
    auto& p = lanes_.p[node];
    const auto rate = [&](std::size_t i) {
      return detail::kRates[lanes_.n[i] >> (8 * node) & 0xff];
    };
#if defined(__SSE2__)
    const __m128i flip = _mm_set1_epi16(bit ? -1 : 0);
    for (std::size_t i = 0; i < kLanes; i += 8) {
      const auto at = [&](std::size_t k) {
        return static_cast<short>(rate(i + k));
      };
      const __m128i rates =
          _mm_set_epi16(at(7), at(6), at(5), at(4), at(3), at(2), at(1), at(0));
      auto* place = reinterpret_cast<__m128i*>(p.data() + i);
      __m128i miss = _mm_xor_si128(_mm_load_si128(place), flip);
      miss = _mm_sub_epi16(miss, _mm_mulhi_epu16(miss, rates));
      miss = _mm_subs_epu16(miss, _mm_set1_epi16(1));
      _mm_store_si128(place, _mm_xor_si128(miss, flip));
    }
#else
    for (std::size_t i = 0; i < kLanes; ++i) p[i] = moved(p[i], bit, rate(i));
#endif
  }

  /// Ages of all lanes + 1, at most Counter::kLimit = 255.
  void grow(std::size_t node) {
#if defined(__SSE2__)
    const __m128i one = _mm_set1_epi16(node == 0 ? 1 : 256);
    for (std::size_t i = 0; i < kLanes; i += 8) {
      auto* n = reinterpret_cast<__m128i*>(lanes_.n.data() + i);
      _mm_store_si128(n, _mm_adds_epu8(_mm_load_si128(n), one));
    }
#else
    for (std::uint16_t& n : lanes_.n) {
      const unsigned shift = node == 0 ? 0 : 8;
      if ((n >> shift & 0xff) != 0xff) {
        n = static_cast<std::uint16_t>(n + (1U << shift));
      }
    }
#endif
  }

  Table<Slot> slots_;
  std::array<std::size_t, kContexts> first_{};
  std::array<int, kContexts> shift_{};
  std::array<Slot*, kLanes> next_{};
  std::array<Slot*, kLanes> active_{};
  alignas(16) std::array<std::uint16_t, kLanes> checks_{};
  SlotLanes<kLanes> lanes_;
  std::array<std::uint8_t, 2> noted_{};
};

}  // namespace unstep::entropy
