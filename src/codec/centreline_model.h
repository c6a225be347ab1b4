#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/centreline_warm_start.h"
#include "codec/line_follower.h"
#include "codec/node_slots.h"
#include "entropy/mixer.h"
#include "entropy/refiner.h"

namespace unstep::codec {

/// Predicts which pixels around the head of a line are ink.
class CentrelineModel : public LineFollower<CentrelineModel> {
 public:
  using Slots = NodeSlots<kContexts, kNodes>;
  static constexpr std::size_t kInputs = Slots::kInputs;
  static constexpr std::size_t kSets = 4;

  using Weights = std::array<std::int16_t, kInputs>;
  /// What the mixer starts with, 12 fractional bits: a vector for each node,
  /// and again for pixels beside one that was found.
  static const std::array<Weights, 2 * kNodes> kInitialWeights;

  /// The planes and rulers must outlive the model; 2^table_bits slots per
  /// context.
  CentrelineModel(const PixelPlanes& planes, const VertexRulers& rulers,
                  int table_bits, const centreline_warm::Table& start);

  /// Bytes that the constructor allocates, rounded up.
  static std::uint64_t memory(int table_bits);

  /// For the training of kInitialWeights and the warm start.
  [[nodiscard]] const auto& mixer() const { return mixer_; }
  [[nodiscard]] const Slots& slots() const { return slots_; }

 private:
  /// The sets whose selectors choose the refiners' contexts, too.
  static constexpr std::array<std::size_t, 2> kRefined{0, 3};
  friend LineFollower<CentrelineModel>;

  void look(const Sight& sight) {
    values_ = contexts(sight);
    sight_ = selectors(sight);
  }
  void ask(unsigned found);
  template <class Coder>
  bool decide(Coder& coder, Node node, bool bit) {
    bit = coder.code(bit, probability(node));
    slots_.note(node, bit);
    for (entropy::Refiner& refiner : refiners_) refiner.learn(bit);
    return bit;
  }
  int probability(Node node);

  Slots slots_;
  entropy::Mixer<kInputs, kSets, kNodes> mixer_;
  std::array<entropy::Refiner, 2> refiners_;

  // What is seen, the slots asked for, and the predictions not yet learned.
  Values values_{};
  Selectors sight_{};
  Selectors selectors_{};
};

}  // namespace unstep::codec
