#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/match_model.h"
#include "codec/start_model.h"
#include "codec/turn_walk.h"
#include "codec/warm_start.h"
#include "entropy/counter.h"
#include "entropy/mixer.h"
#include "entropy/refiner.h"
#include "entropy/slots.h"

namespace unstep::codec {

/// How much a model of turns looks at: everything, or what says most in half
/// the time.
enum class TurnViews : std::uint8_t { all, few };

/// Predicts the turns of contours walked one by one. Encoder and decoder run
/// the same object in step; everything is integer.
template <TurnViews kViews>
class MixedTurnModel : public TurnWalk<kViews == TurnViews::all> {
 public:
  using Walk = TurnWalk<kViews == TurnViews::all>;
  using Starts = StartModel;  ///< what goes with it
  static constexpr bool kAll = kViews == TurnViews::all;
  static constexpr bool kClean = kAll;  ///< for pages without noise
  static constexpr std::size_t kContexts = kAll ? 15 : 6;
  using Slots = entropy::ContextSlots<kContexts>;
  /// Those of the slots; the lane that they leave free is the gate's.
  static constexpr std::size_t kInputs = Slots::kInputs;
  static constexpr std::size_t kGateInput = kContexts;
  static constexpr std::size_t kSets = kAll ? 4 : 3;  ///< of weights
  static constexpr std::size_t kRefiners = kAll ? 2 : 1;

  /// Errors of this many 65536ths teach the weights nothing.
  static constexpr int kSpared = 1000;

  static constexpr int kMaxTableBits = 20;

  /// `cracks` must outlive the model; 2^table_bits slots per context, fewer for
  /// some. REQUIRES: 8 <= table_bits <= kMaxTableBits.
  MixedTurnModel(const CrackMap& cracks, int table_bits,
                 const warm::Table& start);

  /// Bytes that the constructor allocates, rounded up.
  static std::uint64_t memory(int table_bits);

  /// Codes the turn made there. `allowed`: those that are possible, at least
  /// two.
  template <class Coder>
  Turn code(Coder& coder, Turn turn, unsigned allowed) {
    entropy::Counter& gate = this->gate();
    gate_ = &gate;
    if ((allowed & 1U << kStraight) != 0 && this->decides(gate)) {
      const bool bends = coder.code(turn != kStraight, gate.p + 4);
      gate.update(bends);
      if (!bends) return kStraight;
      allowed &= ~1U;
    }
    look_around();
    slots_.learn(
        [this](std::size_t node, bool bit) { mixer_.update(bit, node); });
    slots_.recall();
    selectors_ = next_selectors_;
    refined_ = next_refined_;
    if ((allowed & 1U << kStraight) != 0) {
      const bool bends = coder.code(turn != kStraight, probability(kBends));
      gate.update(bends);
      learn(kBends, bends);
      if (!bends) return kStraight;
    }
    if ((allowed & 1U << kLeft) == 0) return kRight;
    if ((allowed & 1U << kRight) == 0) return kLeft;
    const bool right = coder.code(turn == kRight, probability(kToRight));
    learn(kToRight, right);
    return right ? kRight : kLeft;
  }

  /// Advances: the turn taken at the point, coded or forced, and the step
  /// after it.
  void advance(Turn turn) {
    match_.push(turn);
    this->move_on(turn);
  }

  /// What was learned, for training a warm start.
  [[nodiscard]] const Slots& slots() const { return slots_; }
  [[nodiscard]] const auto& mixer() const { return mixer_; }

 private:
  using typename Walk::Sight;
  using Walk::around_;
  using Walk::bends_;
  using Walk::bulge;
  using Walk::chord;
  using Walk::direction_;
  using Walk::dss_;
  using Walk::forecast;
  using Walk::history;
  using Walk::ink_;
  using Walk::look;
  using Walk::runs_;

  /// The two binary decisions that make a turn.
  enum Node : std::uint8_t { kBends = 0, kToRight = 1 };

  void look_around();
  int probability(Node node);
  void learn(Node node, bool bit) {
    slots_.note(node, bit);
    for (entropy::Refiner& refiner : refiners_) refiner.learn(bit);
  }
  Slots slots_;
  entropy::Counter* gate_ = nullptr;
  entropy::Mixer<kInputs, kSets, 2, kSpared> mixer_;
  /// By the nearest cracks, by the last turns.
  std::array<entropy::Refiner, kRefiners> refiners_;

  MatchModel match_;

  std::array<std::size_t, kSets> next_selectors_{};
  std::array<std::size_t, kSets> selectors_{};
  std::array<std::size_t, kRefiners> next_refined_{};
  std::array<std::size_t, kRefiners> refined_{};
};

using TurnModel = MixedTurnModel<TurnViews::all>;
using LightTurnModel = MixedTurnModel<TurnViews::few>;
extern template class MixedTurnModel<TurnViews::all>;
extern template class MixedTurnModel<TurnViews::few>;

}  // namespace unstep::codec
