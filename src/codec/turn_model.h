#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/crack_map.h"
#include "codec/dss_state.h"
#include "codec/match_model.h"
#include "entropy/counter.h"
#include "entropy/mixer.h"

namespace unstep::codec {

using trace::kLeft;
using trace::kRight;
using trace::kStraight;
using trace::Turn;
using trace::turned;

/// Predicts the turns of contours walked one by one. Encoder and decoder run
/// the same object in step; everything is integer.
class TurnModel {
 public:
  static constexpr std::size_t kContexts = 15;
  static constexpr std::size_t kInputs = 32;

  /// A gate is one counter that decides whether a bend is so unlikely that it
  /// is coded with this counter alone: 2 of 5 steps of a technical drawing.
  static constexpr int kGateBits = 16;
  static constexpr int kGateAge = 24;    ///< observations before it may
  static constexpr int kGateRare = 512;  ///< of 65536

  static constexpr int kMaxTableBits = 16;  ///< what warm records index

  /// `cracks` must outlive the model; 2^table_bits slots per context, fewer for
  /// some. REQUIRES: 8 <= table_bits <= kMaxTableBits.
  TurnModel(const CrackMap& cracks, int table_bits);

  /// Bytes that the constructor allocates, rounded up.
  static std::uint64_t memory(int table_bits);

  /// A contour starts at a point and goes east. `ink`: ink is on the right.
  void begin(CrackMap::Address point, bool ink);

  /// The walk has taken a step along `direction` (the crack is marked) and
  /// stands at the next point; codes the turn made there. `allowed` has bit t
  /// set for each turn t that is possible; at least two are.
  template <class Coder>
  Turn code(Coder& coder, Turn turn, unsigned allowed) {
    entropy::Counter& gate = find_gate();
    if ((allowed & 1U << kStraight) != 0 && gate.n >= kGateAge &&
        gate.p < kGateRare) {
      const bool bends = coder.code(turn != kStraight, gate.p + 4);
      gate.update(bends);
      if (!bends) return kStraight;
      allowed &= ~1U;
    }
    look_around();
    learn();
    recall();
    if ((allowed & 1U << kStraight) != 0) {
      const bool bends = coder.code(turn != kStraight, probability(kBends));
      gate.update(bends);
      pending_[kBends] = bends ? Pending::one : Pending::zero;
      if (!bends) return kStraight;
    }
    if ((allowed & 1U << kLeft) == 0) return kRight;
    if ((allowed & 1U << kRight) == 0) return kLeft;
    const bool right = coder.code(turn == kRight, probability(kToRight));
    pending_[kToRight] = right ? Pending::one : Pending::zero;
    return right ? kRight : kLeft;
  }

  /// Advances: the turn taken at the point, coded or forced, and the step
  /// after it.
  void advance(Turn turn);

  /// One context's memory: a counter for each of the two binary decisions
  /// that make a turn.
  struct Slot {
    std::array<std::uint16_t, 2> p;
    std::array<std::uint8_t, 2> n;
    std::uint16_t check;
  };

  /// What was learned, for training a warm start.
  [[nodiscard]] std::span<const Slot> slots(std::size_t context) const {
    return {slots_.data() + first_[context], std::size_t{1} << bits_[context]};
  }
  [[nodiscard]] const auto& mixer() const { return mixer_; }

 private:
  /// The two binary decisions that make a turn.
  enum Node : std::uint8_t { kBends = 0, kToRight = 1 };
  enum class Pending : std::uint8_t { none, zero, one };

  struct Sight {  ///< the nearest parallel crack on one side
    unsigned distance = 0;
    unsigned shape = 0;
  };

  // The order hides the latency of the slots: look_around() asks for the
  // next ones, learn() works on those of the last turn, recall() reads.
  entropy::Counter& find_gate();
  void look_around();
  void learn();
  void recall();
  int probability(Node node);
  [[nodiscard]] Sight look(int side) const;
  [[nodiscard]] unsigned shape(CrackMap::Address point) const;
  void set_context(std::size_t i, std::uint64_t value);

  const CrackMap& cracks_;
  std::vector<Slot> slots_;
  std::vector<entropy::Counter> gates_;
  std::uint64_t around_ = 0;
  std::array<std::size_t, kContexts> first_{};  ///< each context's slots
  std::array<int, kContexts> bits_{};
  entropy::Mixer<kInputs, 3, 2> mixer_;

  // Where the walk is.
  CrackMap::Address point_ = 0;
  Quarter direction_ = 0;
  bool ink_ = false;

  // What it did.
  std::uint64_t history_ = 0;            ///< two bits a turn, latest lowest
  std::array<std::uint32_t, 4> runs_{};  ///< steps since the last turns
  std::array<std::uint8_t, 3> turns_{};  ///< the last bends
  std::uint32_t steps_ = 0;
  struct Trail {
    std::int32_t x, y;
    std::int64_t area;
  };
  std::array<Trail, 128> trail_{};  ///< the last positions, by steps_ % 128
  Trail here_{};
  DssState dss_;
  MatchModel match_;

  // The slots asked for, and the prediction in progress or not yet learned.
  std::array<Slot*, kContexts> next_{};
  std::array<std::uint16_t, kContexts> checks_{};
  std::array<std::size_t, 3> next_selectors_{};
  std::array<Slot*, kContexts> active_{};
  std::array<std::size_t, 3> selectors_{};
  /// One node's counters side by side, for vector code.
  struct Counters {
    alignas(16) std::array<std::uint16_t, 16> p{};
    alignas(16) std::array<std::uint16_t, 16> rate{};
  };
  std::array<Counters, 2> counters_{};
  std::array<Pending, 2> pending_{};
};

}  // namespace unstep::codec
