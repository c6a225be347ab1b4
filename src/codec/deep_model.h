#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/context.h"
#include "entropy/counter.h"
#include "entropy/deep_mixer.h"
#include "entropy/logistic.h"
#include "entropy/refiner.h"
#include "entropy/table_memory.h"

namespace unstep::codec {

namespace detail {

/// Observation n + 1 moves a probability by rate / 65536 of the way.
constexpr std::array<std::uint16_t, 1024> make_deep_rates() {
  std::array<std::uint16_t, 1024> rates{};
  for (unsigned n = 0; n < rates.size(); ++n) {
    rates[n] = static_cast<std::uint16_t>(655360U / (10 * n + 13));
  }
  return rates;
}
inline constexpr auto kDeepRates = make_deep_rates();

/// 0..7: an age beyond the outcomes that are remembered.
constexpr std::array<std::uint8_t, 1024> make_deep_levels() {
  constexpr std::array<unsigned, 7> kSteps{8, 14, 24, 48, 100, 200, 500};
  std::array<std::uint8_t, 1024> levels{};
  for (unsigned n = 0; n < levels.size(); ++n) {
    for (const unsigned step : kSteps) {
      levels[n] = static_cast<std::uint8_t>(levels[n] + (n >= step ? 1 : 0));
    }
  }
  return levels;
}
inline constexpr auto kDeepLevels = make_deep_levels();

}  // namespace detail

/// The model of the max effort and of small drawings: predicts binary decisions
/// from kContexts hashed contexts, with every means that pays when there is
/// time. A context has a slot with, for each of kNodes kinds of decision, a
/// probability with its age and the last seven outcomes. It says three things:
/// its probability, how far that is from one half weighed by age, and what came
/// in this context after the same outcomes at a like age. They are mixed by
/// kSets sets of weights, and these by a last one; kRefiners refiners correct
/// the result. kExtras more inputs are the owner's.
///
/// Per decision: ask() for every context (once for the decisions of a symbol),
/// predict(), code, learn().
template <std::size_t kContexts, std::size_t kExtras, std::size_t kSets,
          std::size_t kRefiners, std::size_t kNodes = 1>
class DeepModel {
 public:
  static constexpr std::size_t kFirstExtra = 3 * kContexts;
  static constexpr std::size_t kInputs =
      (kFirstExtra + kExtras + 1 + 7) / 8 * 8;
  using Mixer = entropy::DeepMixer<kInputs, kSets>;
  using Weights = typename Mixer::Inputs;

  /// Which vectors and contexts of refiners a decision has.
  struct Choice {
    std::array<std::size_t, kSets> vectors{};
    std::array<std::size_t, kRefiners> refined{};
    std::size_t last = 0;

    [[nodiscard]] Choice operator+(std::size_t node) const {
      Choice sum = *this;
      for (std::size_t& vector : sum.vectors) vector += node;
      for (std::size_t& context : sum.refined) context += node;
      sum.last += node;
      return sum;
    }
  };

  /// 2^table_bits slots per context; `sizes`: one more than the largest of
  /// each. REQUIRES: 8 <= table_bits <= 24.
  DeepModel(int table_bits, const Choice& sizes)
      : DeepModel(table_bits, sizes, std::array<Weights, 1>{even()}) {}
  DeepModel(int table_bits, const Choice& sizes,
            std::span<const Weights> initial)
      : bits_(table_bits),
        slots_(entropy::make_table<Slot>(kContexts << table_bits)),
        followed_(kContexts * kNodes * kPasts),
        mixer_(sizes.vectors, sizes.last, initial) {
    active_.fill(slots_.get());
    for (std::size_t i = 0; i < followed_.size(); ++i) {
      followed_[i] =
          i < 256 ? after(static_cast<unsigned>(i)) : followed_[i - 256];
    }
    for (const std::size_t contexts : sizes.refined) {
      refiners_.emplace_back(contexts);
    }
  }

  /// Bytes that the constructor allocates.
  static std::uint64_t memory(int table_bits, const Choice& sizes) {
    std::uint64_t bytes = std::uint64_t{kContexts * sizeof(Slot)} << table_bits;
    bytes += kContexts * kNodes * kPasts * sizeof(entropy::Counter);
    bytes += Mixer::memory(sizes.vectors);
    for (const std::size_t contexts : sizes.refined) {
      bytes += entropy::Refiner::memory(contexts);
    }
    return bytes;
  }

  /// The slot of context i for a hash of which the upper bits are good.
  void ask(std::size_t i, std::uint64_t hash) {
    Slot& slot = slots_[(i << bits_) + (hash >> (64 - bits_))];
    const auto check = static_cast<std::uint16_t>((hash >> 36 & 0xfff) + 1);
    if (slot.check != check) renew(slot, check);
    active_[i] = &slot;
  }
  /// The same for a number that is not hashed yet.
  void ask_mixed(std::size_t i, std::uint64_t value) {
    ask(i, mix(value, i) * kGolden);
  }

  /// The owner's k-th input, a stretch. They stay as they are.
  void set_extra(std::size_t k, int stretch) {
    mixer_.inputs()[kFirstExtra + k] = static_cast<std::int16_t>(stretch);
  }

  /// The probability of 65536 of a one.
  int predict(const Choice& choice, std::size_t node = 0) {
    auto& inputs = mixer_.inputs();
    for (std::size_t i = 0; i < kContexts; ++i) {
      const std::uint32_t state = active_[i]->state[node];
      const auto p = static_cast<int>(state >> 16);
      const std::uint32_t age = state & kMostAge;
      entropy::Counter& past =
          followed_[(i * kNodes + node) * kPasts +
                    (std::size_t{detail::kDeepLevels[age]} << 8) +
                    active_[i]->seen[node]];
      pasts_[i] = &past;
      inputs[i] = static_cast<std::int16_t>(entropy::stretch(p));
      inputs[kContexts + i] = static_cast<std::int16_t>(
          ((p - 32768) * kTrust[std::min(age, 255U)]) >> 16);
      inputs[2 * kContexts + i] =
          static_cast<std::int16_t>(age == 0 ? 0 : entropy::stretch(past.p));
    }
    inputs[kInputs - 1] = 77;
    node_ = node;
    const int x = mixer_.mix(choice.vectors, choice.last);
    int p = entropy::squash(x);
    for (std::size_t i = 0; i < kRefiners; ++i) {
      p += refiners_[i].refine(x, choice.refined[i]);
    }
    return std::clamp(p / static_cast<int>(1 + kRefiners), 8, 65528);
  }

  /// What was predicted last has become `bit`.
  void learn(bool bit) {
    for (entropy::Refiner& refiner : refiners_) refiner.learn(bit);
    mixer_.update(bit);
    for (std::size_t i = 0; i < kContexts; ++i) {
      pasts_[i]->update(bit);
      std::uint32_t& state = active_[i]->state[node_];
      const std::uint32_t age = state & kMostAge;
      const auto p = static_cast<std::int32_t>(state >> 10);
      const std::int64_t way = (bit ? kCertain : 0) - p;
      const auto moved =
          static_cast<std::int32_t>(p + (way * detail::kDeepRates[age] >> 16));
      state = static_cast<std::uint32_t>(std::clamp(moved, 32, kCertain - 31))
                  << 10 |
              std::min(age + 1, kMostAge);
      std::uint8_t& seen = active_[i]->seen[node_];
      // A one leads the outcomes; the eighth pushes the first out.
      const unsigned next = seen * 2U + (bit ? 1U : 0U);
      seen = static_cast<std::uint8_t>(next < 256 ? next : (next & 127) | 128);
    }
  }

  template <class Coder>
  bool code(Coder& coder, bool bit, const Choice& choice,
            std::size_t node = 0) {
    bit = coder.code(bit, predict(choice, node));
    learn(bit);
    return bit;
  }

  /// For a warm start: the slot of the hash whose upper 28 bits these are has
  /// seen as much for a node as says a probability with an age.
  void know(std::size_t i, std::uint32_t upper_bits, std::size_t node,
            std::uint16_t p, std::uint8_t age) {
    Slot& slot = slots_[(i << bits_) + (upper_bits >> (28 - bits_))];
    const auto check = static_cast<std::uint16_t>((upper_bits & 0xfff) + 1);
    if (slot.check != check) renew(slot, check);
    slot.state[node] = std::uint32_t{p} << 16 | age;
    const unsigned outcomes = std::min<unsigned>(age, 7);
    const unsigned ones = (p * outcomes + 32768U) >> 16;
    slot.seen[node] =
        static_cast<std::uint8_t>((1U << outcomes) | ((1U << ones) - 1));
  }

  /// For a warm start: vector `number`, counted through the sets, begins with
  /// these weights, 12 fractional bits, as if it had seen `age` bits.
  void begin(std::size_t number, const Weights& weights, std::uint16_t age) {
    mixer_.begin(number, weights, age);
  }

  /// What was learned, for training a warm start: calls `apply(upper_bits,
  /// node, p, age)` for what know() would have to be told of context i. Of
  /// 2^16 slots or more.
  template <class Apply>
  void for_each_known(std::size_t i, Apply apply) const {
    for (std::uint32_t k = 0; k < (1U << bits_); ++k) {
      const Slot& slot = slots_[(i << bits_) + k];
      if (slot.check == 0) continue;
      const std::uint32_t upper = (k >> (bits_ - 16)) << 12 | (slot.check - 1U);
      for (std::size_t node = 0; node < kNodes; ++node) {
        const std::uint32_t age = slot.state[node] & kMostAge;
        if (age > 0) apply(upper, node, slot.state[node] >> 16, age);
      }
    }
  }
  [[nodiscard]] const Mixer& mixer() const { return mixer_; }

 private:
  static constexpr std::size_t kPasts = 2048;  ///< levels of age and outcomes
  static constexpr std::uint32_t kMostAge = 1023;
  static constexpr std::int32_t kCertain = (1 << 22) - 1;

  struct Slot {
    /// A probability of 22 bits, then an age of 10, for each node.
    std::array<std::uint32_t, kNodes> state;
    std::uint16_t check;
    std::array<std::uint8_t, kNodes> seen;
  };

  static void renew(Slot& slot, std::uint16_t check) {
    slot.state.fill(std::uint32_t{1} << 31);
    slot.seen.fill(1);
    slot.check = check;
  }
  static entropy::Counter after(unsigned outcomes) {
    const int n = std::max(static_cast<int>(std::bit_width(outcomes)) - 1, 0);
    const int ones = std::max(std::popcount(outcomes) - 1, 0);
    return {static_cast<std::uint16_t>((2 * ones + 1) * 65535 / (2 * n + 2)),
            6};
  }
  static constexpr Weights even() {
    Weights weights{};
    for (std::size_t i = 0; i < kContexts; ++i) {
      weights[i] = static_cast<std::int16_t>(5200 / kContexts);
      weights[kContexts + i] = static_cast<std::int16_t>(2000 / kContexts);
      weights[2 * kContexts + i] = static_cast<std::int16_t>(1500 / kContexts);
    }
    return weights;
  }

  int bits_;
  entropy::Table<Slot> slots_;
  std::vector<entropy::Counter> followed_;
  Mixer mixer_;
  std::vector<entropy::Refiner> refiners_;
  std::array<Slot*, kContexts> active_{};
  std::array<entropy::Counter*, kContexts> pasts_{};
  std::size_t node_ = 0;
};

}  // namespace unstep::codec
