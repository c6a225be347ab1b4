#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "codec/chain_coder.h"
#include "codec/number_model.h"
#include "entropy/counter.h"

namespace unstep::codec {

/// Predicts everything of a chain but its steps.
class ChainHeadModel {
 public:
  /// `expected`: where the chain before ended. `left`: the steps that are left
  /// of the payload. `last`: it is the last chain and has all of them.
  /// The result is what was coded, not checked.
  template <class Coder>
  ChainHead code(Coder& coder, const ChainHead& head, Point expected,
                 std::uint64_t left, bool last) {
    ChainHead h;
    const bool four = NumberModel::decide(
        coder, four_[four_before_], head.connectivity == Connectivity::four);
    four_before_ = four ? 1 : 0;
    h.connectivity = four ? Connectivity::four : Connectivity::eight;
    h.closed = NumberModel::decide(coder, closed_[closed_before_], head.closed);
    closed_before_ = h.closed ? 1 : 0;
    const std::int64_t dx =
        code_move(coder, 0, std::int64_t{head.origin.x} - expected.x);
    const std::size_t far = static_cast<std::size_t>(std::min(
        3, (static_cast<int>(
                std::bit_width(static_cast<std::uint64_t>(dx < 0 ? -dx : dx))) +
            2) /
               3));
    const std::int64_t dy =
        code_move(coder, 1 + far, std::int64_t{head.origin.y} - expected.y);
    outside_ = !in_range(expected.x + dx) || !in_range(expected.y + dy);
    if (!outside_) {
      h.origin = {static_cast<std::int32_t>(expected.x + dx),
                  static_cast<std::int32_t>(expected.y + dy)};
    }
    h.steps = last ? left : steps_[closed_before_].code(coder, head.steps);
    return h;
  }

  /// Whether the last origin was out of the coordinate range.
  [[nodiscard]] bool outside() const { return outside_; }

  static bool in_range(std::int64_t coordinate) {
    return coordinate >= -kMaxCoord && coordinate <= kMaxCoord;
  }

 private:
  template <class Coder>
  std::int64_t code_move(Coder& coder, std::size_t context, std::int64_t move) {
    const auto size = static_cast<std::uint64_t>(move < 0 ? -move : move);
    const auto coded =
        static_cast<std::int64_t>(moves_[context].code(coder, size));
    if (coded == 0) return 0;
    const bool negative = NumberModel::decide(coder, signs_[context], move < 0);
    return negative ? -coded : coded;
  }

  std::array<entropy::Counter, 2> four_;
  std::array<entropy::Counter, 2> closed_;
  std::array<NumberModel, 5> moves_;
  std::array<entropy::Counter, 5> signs_;
  std::array<NumberModel, 2> steps_;
  std::size_t four_before_ = 0;
  std::size_t closed_before_ = 0;
  bool outside_ = false;
};

}  // namespace unstep::codec
