#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/chain_coder.h"
#include "codec/density_grid.h"
#include "codec/number_model.h"
#include "codec/start_position_model.h"
#include "entropy/counter.h"

namespace unstep::codec {

/// Predicts what kind of chain comes and, of open ones, how long it is.
class ChainKindModel {
 public:
  template <class Coder>
  void code_kind(Coder& coder, const ChainHead& head, ChainHead& coded) {
    const bool four = NumberModel::decide(
        coder, four_[four_before_], head.connectivity == Connectivity::four);
    four_before_ = four ? 1 : 0;
    coded.connectivity = four ? Connectivity::four : Connectivity::eight;
    coded.closed =
        NumberModel::decide(coder, closed_[closed_before_], head.closed);
    closed_before_ = coded.closed ? 1 : 0;
  }

  template <class Coder>
  std::uint64_t code_steps(Coder& coder, std::uint64_t steps) {
    return steps_.code(coder, steps);
  }

  /// Of a closed chain: whether it has a step.
  template <class Coder>
  bool code_some(Coder& coder, bool some) {
    return NumberModel::decide(coder, some_, some);
  }

  /// Of a closed chain that is at its origin again: whether it ends here.
  /// `returns`: how often it was there before; `turn`: from the last step to
  /// the first one.
  template <class Coder>
  bool code_end(Coder& coder, unsigned returns, unsigned turn, bool end) {
    return NumberModel::decide(
        coder, ends_[std::min<std::size_t>(returns, 2)][turn & 7], end);
  }

 private:
  std::array<entropy::Counter, 2> four_;
  std::array<entropy::Counter, 2> closed_;
  NumberModel steps_;
  entropy::Counter some_;
  std::array<std::array<entropy::Counter, 8>, 3> ends_;
  std::size_t four_before_ = 0;
  std::size_t closed_before_ = 0;
};

/// Whether a point is one that chains may visit.
[[nodiscard]] constexpr bool in_coordinate_range(std::int64_t x,
                                                 std::int64_t y) {
  return x >= -kMaxCoord && x <= kMaxCoord && y >= -kMaxCoord && y <= kMaxCoord;
}

/// Everything of a chain but its steps: the origin by the density of what
/// chains have visited.
class ChainHeadModel {
 public:
  explicit ChainHeadModel(std::uint64_t chains)
      : starts_(chains < 2'000 ? 13 : 15) {}

  /// log2 of the step model's slots per context, a rule of the payload's steps
  /// only, so that it need not be stored.
  static constexpr int table_bits(std::uint64_t steps) {
    return steps < 5'000 ? 12 : steps < 50'000 ? 14 : 16;
  }

  template <class Coder>
  void code_frame(Coder& coder, const StartFrame& frame) {
    starts_.code_frame(coder, frame);
  }

  /// `left`: the steps that are left of the payload. `last`: it is the last
  /// chain and has all of them. The result is what was coded, not checked; a
  /// closed chain with steps has `left` of them, for it ends by code_end().
  template <class Coder>
  ChainHead code(Coder& coder, const ChainHead& head, std::uint64_t left,
                 bool last) {
    ChainHead h;
    kind_.code_kind(coder, head, h);
    if (h.closed) {
      const bool some = left > 0 && kind_.code_some(coder, head.steps > 0);
      h.steps = some ? left : 0;
    } else {
      h.steps = last ? left : kind_.code_steps(coder, head.steps);
    }
    const Vec start = starts_.code(coder, head.origin, density_);
    outside_ = !in_coordinate_range(start.x, start.y);
    if (!outside_) {
      h.origin = {static_cast<std::int32_t>(start.x),
                  static_cast<std::int32_t>(start.y)};
    }
    visits_ = 0;
    return h;
  }

  /// Whether the last origin was out of the coordinate range.
  [[nodiscard]] bool outside() const { return outside_; }

  template <class Coder>
  bool code_end(Coder& coder, unsigned returns, unsigned turn, bool end) {
    return kind_.code_end(coder, returns, turn, end);
  }

  /// Every fourth point is enough for the density.
  void visit(Point at) {
    if (visits_++ % 4 == 0) density_.add(at);
  }

 private:
  ChainKindModel kind_;
  StartPositionModel starts_;
  DensityGrid density_;
  unsigned visits_ = 0;
  bool outside_ = false;
};

}  // namespace unstep::codec
