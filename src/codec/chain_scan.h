#pragma once

#include <cstdint>
#include <string>

#include "codec/block_coder.h"
#include "codec/chain_coder.h"
#include "codec/chain_head_model.h"
#include "codec/chain_model.h"

namespace unstep::codec {

/// Coder 16, both sides: chains one by one, each its head and then its steps.
/// Encoder and decoder run this same code; `Side` is what differs:
///
///     frame()      what holds for all chains
///     coder()      an arithmetic encoder or decoder
///     head(i)      the true head of chain i
///     step(i, k)   the true step k of chain i
///     begin(head)  a chain's head is complete
///     push(step)   so is a step of it
///     damaged()    the payload cannot be right; give up
///
/// The decoder's answers to the questions are never looked at. Here y grows
/// with Freeman code 2, whatever the canvas says.
template <class Side>
class ChainScan {
 public:
  ChainScan(Side& side, std::uint64_t count, std::uint64_t steps)
      : side_(side),
        count_(count),
        left_(steps),
        heads_(count),
        model_(ChainHeadModel::table_bits(steps)) {}

  Status run(const BlockProgress& progress) {
    if (count_ > 0) heads_.code_frame(side_.coder(), side_.frame());
    for (std::uint64_t i = 0; i < count_; ++i) {
      if (progress && i % 64 == 63 && !progress(i)) return cancelled();
      const bool last = i + 1 == count_;
      const ChainHead head =
          heads_.code(side_.coder(), side_.head(i), left_, last);
      if (side_.damaged() || heads_.outside() || head.steps > left_) {
        return damaged(i);
      }
      side_.begin(head);
      model_.begin(head);
      heads_.visit(head.origin);
      const Status done = code_steps(i, head, progress);
      if (!done) return done;
    }
    // Of no chains there are no steps.
    return left_ == 0 ? Status() : damaged(0);
  }

 private:
  static Error cancelled() { return {ErrorCode::cancelled, "cancelled"}; }
  static Error damaged(std::uint64_t i) {
    return {ErrorCode::corrupt,
            "chain payload is damaged at chain " + std::to_string(i + 1)};
  }

  Status code_steps(std::uint64_t i, const ChainHead& head,
                    const BlockProgress& progress) {
    Step first = 0;
    unsigned returns = 0;
    for (std::uint64_t k = 0; k < head.steps; ++k) {
      Step step = side_.step(i, k);
      if (side_.damaged()) return damaged(i);
      model_.code(side_.coder(), step);
      const Point at = model_.position();
      if (!in_coordinate_range(at.x, at.y)) return damaged(i);
      heads_.visit(at);
      side_.push(step);
      --left_;
      if (k == 0) first = step;
      if (head.closed && at == head.origin) {
        if (left_ == 0) return {};
        const auto turn = static_cast<unsigned>(first - step);
        const bool end = k + 1 == side_.head(i).steps;
        if (heads_.code_end(side_.coder(), returns++, turn, end)) return {};
      }
      if (progress && k % 65536 == 65535 && !progress(i)) return cancelled();
    }
    // A closed chain has returned before, unless it has no steps.
    return head.closed && head.steps > 0 ? damaged(i) : Status();
  }

  Side& side_;
  std::uint64_t count_;
  std::uint64_t left_;  ///< steps of the chains to come
  ChainHeadModel heads_;
  ChainModel model_;
};

}  // namespace unstep::codec
