#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/context.h"
#include "entropy/counter.h"
#include "entropy/mixer.h"
#include "entropy/refiner.h"
#include "entropy/table_memory.h"

namespace unstep::codec {

/// Predicts binary decisions from kContexts contexts. The value of each
/// context is set once for a whole number; every decision of the number has a
/// node of its own. A context and a node together name a counter of a table
/// without checks. The mixer has kSets sets of weights; `kRefined`: what it
/// says is averaged with what followed where it said the same, under each of
/// the first two selectors; `kKnown`: one more set is chosen by how many of the
/// counters have seen bits, and how many of them many, which tells apart what
/// is new from what is well known where there is little to learn from.
template <std::size_t kContexts, std::size_t kSets = 2, bool kRefined = false,
          bool kKnown = false>
class DecisionModel {
 public:
  static constexpr std::size_t kInputs = (2 * kContexts + 1 + 7) / 8 * 8;
  static constexpr std::size_t kSelectors = 1024;  ///< of each set
  using Weights = std::array<std::int16_t, kInputs>;
  using Selectors = std::array<std::uint32_t, kSets>;
  using Values = std::array<std::uint64_t, kContexts>;

  DecisionModel(int table_bits, std::span<const Weights> initial)
      : table_bits_(table_bits),
        counters_(
            entropy::make_table(kContexts << table_bits, entropy::Counter{})),
        mixer_(all_selectors(), initial) {
    if constexpr (kRefined) refiners_.assign(2, entropy::Refiner(kSelectors));
  }

  /// Bytes that the constructor allocates, without the mixer.
  static constexpr std::uint64_t memory(int table_bits) {
    return std::uint64_t{kContexts * sizeof(entropy::Counter)} << table_bits;
  }

  void set_contexts(const Values& values) { values_ = values; }

  /// `selectors` are taken modulo kSelectors.
  template <class Coder>
  bool code(Coder& coder, bool bit, std::uint32_t node,
            const Selectors& selectors) {
    auto& inputs = mixer_.inputs();
    std::array<entropy::Counter*, kContexts> active{};
    for (std::size_t i = 0; i < kContexts; ++i) {
      const std::uint64_t hash = mix(values_[i] + i, node) * kGolden;
      active[i] = &counters_[(i << table_bits_) + (hash >> (64 - table_bits_))];
      const entropy::Counter& c = *active[i];
      inputs[2 * i] = static_cast<std::int16_t>(entropy::stretch(c.p));
      inputs[2 * i + 1] =
          static_cast<std::int16_t>(((c.p - 32768) * kTrust[c.n]) >> 16);
    }
    inputs[2 * kContexts] = 77;
    Chosen chosen{};
    for (std::size_t s = 0; s < kSets; ++s) {
      chosen[s] = selectors[s] % kSelectors;
    }
    if constexpr (kKnown) chosen[kSets] = known(active);
    const int x = mixer_.mix(chosen);
    int p = entropy::squash(x);
    if constexpr (kRefined) {
      p = (2 * p + refiners_[0].refine(x, chosen[0]) +
           refiners_[1].refine(x, chosen[1])) /
          4;
    }
    bit = coder.code(bit, std::clamp(p, 8, 65528));
    for (entropy::Refiner& refiner : refiners_) refiner.learn(bit);
    mixer_.update(bit);
    for (entropy::Counter* c : active) c->update(bit);
    return bit;
  }

  /// For a warm start and its training: counter `index` of a table of
  /// context i as if it had 2^16 entries.
  [[nodiscard]] entropy::Counter& counter(std::size_t i, std::uint32_t index) {
    return counters_[(i << table_bits_) + (index >> (16 - table_bits_))];
  }
  [[nodiscard]] auto& mixer() { return mixer_; }
  [[nodiscard]] const auto& mixer() const { return mixer_; }

 private:
  static constexpr std::size_t kAllSets = kSets + (kKnown ? 1 : 0);
  static constexpr std::uint8_t kMany = 6;
  using Chosen = std::array<std::size_t, kAllSets>;

  static constexpr Chosen all_selectors() {
    Chosen all{};
    all.fill(kSelectors);
    return all;
  }
  static std::size_t known(
      const std::array<entropy::Counter*, kContexts>& active) {
    std::size_t some = 0;
    std::size_t many = 0;
    for (const entropy::Counter* c : active) {
      some += c->n > 0 ? 1 : 0;
      many += c->n > kMany ? 1 : 0;
    }
    return some * (kContexts + 1) + many;
  }

  int table_bits_;
  entropy::Table<entropy::Counter> counters_;
  entropy::Mixer<kInputs, kAllSets> mixer_;
  std::vector<entropy::Refiner> refiners_;
  Values values_{};
};

}  // namespace unstep::codec
