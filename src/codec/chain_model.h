#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/chain_coder.h"
#include "codec/chain_match.h"
#include "codec/chain_track.h"
#include "codec/chain_visits.h"
#include "codec/dss_state.h"
#include "codec/node_slots.h"
#include "entropy/mixer.h"

namespace unstep::codec {

/// Predicts the steps of chains. Encoder and decoder run the same object in
/// step; everything is integer.
///
/// A turn is the difference of a step to the one before, modulo 8, so 4 turns
/// back. It is coded as up to five binary decisions.
class ChainModel {
 public:
  static constexpr std::size_t kContexts = 15;
  static constexpr std::size_t kDecisions = 5;  ///< of one turn, at most
  using Slots = NodeSlots<kContexts, kDecisions>;
  static constexpr std::size_t kInputs = Slots::kInputs;

  using Weights = std::array<std::int16_t, kInputs>;
  /// What the mixer starts with, 12 fractional bits: a vector for each node,
  /// the last for none.
  static const std::array<Weights, 8> kInitialWeights;

  /// 2^table_bits slots per context.
  explicit ChainModel(int table_bits);

  /// A chain starts at an origin.
  void begin(const ChainHead& head);

  /// Codes the next step and goes along it.
  template <class Coder>
  void code(Coder& coder, Step& step) {
    // The order hides the latency of the slots: the first asks for them, the
    // second works on those of the step before.
    ask_slots();
    learn_last();
    const unsigned turn =
        code_turn(coder, (step - track_.direction()) & 7U, four_ ? 0x55 : 0xff);
    step = static_cast<Step>((track_.direction() + turn) & 7U);
    advance(turn);
  }

  [[nodiscard]] Point position() const { return track_.position(); }

  /// For the training of kInitialWeights.
  [[nodiscard]] const auto& mixer() const { return mixer_; }

 private:
  /// The binary decisions of a turn: whether there is one, to which side, and
  /// whether it is beyond 1, 2, 3 eighths.
  enum Node : std::uint8_t {
    kBends,
    kToRight,
    kLeft2,
    kLeft3,
    kLeft4,
    kRight2,
    kRight3,
    kNodes
  };

  template <class Coder>
  unsigned code_turn(Coder& coder, unsigned turn, unsigned allowed) {
    // `ones`: the turns that the decision's 1 leaves, of those in question.
    const auto decide = [&](Node node, unsigned ones) {
      ones &= allowed;
      bool one = ones != 0;
      if (one && ones != allowed) {
        one = coder.code((ones >> turn & 1) != 0, probability(node));
        slots_.note(node, one);
      }
      allowed = one ? ones : allowed & ~ones;
      return one;
    };
    if (!decide(kBends, 0xfe)) return 0;
    if (decide(kToRight, 0xe0)) {
      if (!decide(kRight2, 0x60)) return 7;
      return decide(kRight3, 0x20) ? 5 : 6;
    }
    if (!decide(kLeft2, 0x1c)) return 1;
    if (!decide(kLeft3, 0x18)) return 2;
    return decide(kLeft4, 0x10) ? 4 : 3;
  }

  void ask_slots();
  void learn_last();
  int probability(Node node);
  void advance(unsigned turn);
  [[nodiscard]] std::uint64_t home() const;
  [[nodiscard]] std::uint64_t rows_below() const;

  Slots slots_;
  entropy::Mixer<kInputs, 3, kDecisions> mixer_;
  ChainMatch match_;
  ChainVisits visits_;

  // The chain.
  ChainTrack track_{YAxis::up};
  bool closed_ = false;
  bool four_ = false;

  DssState dss_;

  // The slots asked for, and the prediction in progress or not yet learned.
  std::array<std::size_t, 3> next_selectors_{};
  std::array<std::size_t, 3> selectors_{};
};

}  // namespace unstep::codec
