#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/deep_model.h"
#include "codec/deep_start_model.h"
#include "codec/deep_warm_start.h"
#include "codec/edge_forecast.h"
#include "codec/match_model.h"
#include "codec/start_model.h"
#include "codec/turn_walk.h"
#include "codec/warm_start.h"
#include "entropy/counter.h"

namespace unstep::codec {

/// Predicts the turns of contours for the max effort and, with a warm start of
/// its own, of small drawings: the contexts of
/// MixedTurnModel and fifteen more, in a DeepModel, with an EdgeForecast.
class DeepTurnModel : public TurnWalk<true> {
 public:
  using Starts = DeepStartModel;
  static constexpr bool kClean = true;
  static constexpr std::size_t kContexts = 30;
  static constexpr std::size_t kSets = 10;
  static constexpr std::size_t kRefiners = 5;

  /// `cracks` must outlive the model; 2^table_bits slots per context.
  /// REQUIRES: 8 <= table_bits <= 20.
  DeepTurnModel(const CrackMap& cracks, int table_bits,
                const warm::Table& start);
  /// With a warm start of its own, whose vectors move as after `age` bits.
  DeepTurnModel(const CrackMap& cracks, int table_bits,
                const warm::DeepTable& start, std::uint16_t age);

  /// Bytes that the constructor allocates, rounded up.
  static std::uint64_t memory(int table_bits);

  using Model = DeepModel<kContexts, 3, kSets, kRefiners, 2>;
  /// What was learned, for training a warm start.
  [[nodiscard]] const Model& model() const { return model_; }

  /// As of TurnWalk.
  void begin(CrackMap::Address point, CrackMap::Address flipped, bool ink) {
    TurnWalk::begin(point, flipped, ink);
    edges_.begin(ink);
  }

  /// Codes the turn made at the point. `allowed`: those that are possible, at
  /// least two.
  template <class Coder>
  Turn code(Coder& coder, Turn turn, unsigned allowed) {
    entropy::Counter& gate = this->gate();
    if ((allowed & 1U << kStraight) != 0 && decides(gate)) {
      const bool bends = coder.code(turn != kStraight, gate.p + 4);
      gate.update(bends);
      if (!bends) return kStraight;
      allowed &= ~1U;
    }
    look_around();
    if ((allowed & 1U << kStraight) != 0) {
      model_.set_extra(0, entropy::stretch(gate.p));
      expect(edges_.bends());
      const bool bends =
          model_.code(coder, turn != kStraight, choice_ + kBends, kBends);
      gate.update(bends);
      if (!bends) return kStraight;
    }
    if ((allowed & 1U << kLeft) == 0) return kRight;
    if ((allowed & 1U << kRight) == 0) return kLeft;
    model_.set_extra(0, 0);
    expect(edges_.right());
    const bool right =
        model_.code(coder, turn == kRight, choice_ + kToRight, kToRight);
    return right ? kRight : kLeft;
  }

  /// Advances: the turn taken at the point, coded or forced, and the step
  /// after it.
  void advance(Turn turn) {
    match_.push(turn);
    long_match_.push(turn);
    move_on(turn);
    edges_.step(direction_);
  }

 private:
  /// The two binary decisions that make a turn.
  enum Node : std::uint8_t { kBends = 0, kToRight = 1 };
  static const Model::Choice kSizes;
  static std::array<Model::Weights, 2> first_weights(const warm::Table& start);

  void know(std::size_t context, const warm::Record& record);
  void look_around();
  void ask_about_edges(std::uint64_t base, const Sight& right,
                       const Sight& left);
  void choose(const Sight& right, const Sight& left, std::uint64_t curve);
  void expect(int probability);

  EdgeForecast edges_;
  Model model_;
  Model::Choice choice_;
  MatchModel match_;
  TurnMatch<32> long_match_;
};

/// The same for small drawings, which end before it has learned anything: it
/// begins with what other small drawings taught.
class SmallTurnModel : public DeepTurnModel {
 public:
  using Starts = StartModel;

  /// `start` is for the starts.
  SmallTurnModel(const CrackMap& cracks, int table_bits,
                 const warm::Table& /*start*/)
      : DeepTurnModel(cracks, table_bits, warm::kDeepTurns, kKnownAge) {}

 private:
  static constexpr std::uint16_t kKnownAge = 2000;
};

/// The same for training the warm start: what it is told moves fast.
class TrainedTurnModel : public DeepTurnModel {
 public:
  using Starts = StartModel;

  TrainedTurnModel(const CrackMap& cracks, int table_bits,
                   const warm::Table& /*start*/)
      : DeepTurnModel(cracks, table_bits, warm::kDeepTurns, 0) {}
};

}  // namespace unstep::codec
