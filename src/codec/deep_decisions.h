#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codec/context.h"
#include "codec/decision_model.h"
#include "codec/deep_model.h"

namespace unstep::codec {

/// A DeepModel with the interface of a DecisionModel.
template <std::size_t kContexts, std::size_t kSets>
class DeepDecisions {
 public:
  static constexpr std::size_t kSelectors = 1024;  ///< of each set
  using Selectors = std::array<std::uint32_t, kSets>;
  using Values = std::array<std::uint64_t, kContexts>;
  using Plain = DecisionModel<kContexts, kSets>;

  DeepDecisions(int table_bits,
                std::span<const typename Plain::Weights> initial)
      : model_(table_bits, sizes(), first_weights(initial[0])) {}

  static std::uint64_t memory(int table_bits) {
    return Model::memory(table_bits, sizes());
  }

  void set_contexts(const Values& values) { values_ = values; }

  template <class Coder>
  bool code(Coder& coder, bool bit, std::uint32_t node,
            const Selectors& selectors) {
    for (std::size_t i = 0; i < kContexts; ++i) {
      model_.ask_mixed(i, mix(values_[i], node));
    }
    typename Model::Choice choice;
    for (std::size_t s = 0; s < kSets; ++s) {
      choice.vectors[s] = selectors[s] % kSelectors;
    }
    choice.refined = {choice.vectors[0], choice.vectors[1]};
    return model_.code(coder, bit, choice);
  }

 private:
  using Model = DeepModel<kContexts, 0, kSets, 2>;

  static typename Model::Choice sizes() {
    typename Model::Choice all;
    all.vectors.fill(kSelectors);
    all.refined.fill(kSelectors);
    all.last = 1;
    return all;
  }
  static std::array<typename Model::Weights, 1> first_weights(
      const typename Plain::Weights& from) {
    typename Model::Weights to{};
    for (std::size_t i = 0; i < kContexts; ++i) {
      to[i] = from[2 * i];
      to[kContexts + i] = from[2 * i + 1];
    }
    to[Model::kInputs - 1] = from[2 * kContexts];
    return {to};
  }

  Model model_;
  Values values_{};
};

}  // namespace unstep::codec
