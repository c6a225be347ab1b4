#pragma once

#include <cstdint>
#include <string>

#include "codec/block_coder.h"
#include "codec/chain_coder.h"
#include "codec/chain_head_model.h"
#include "codec/chain_model.h"
#include "codec/segment_model.h"

namespace unstep::codec {

/// Coder 16, both sides: chains one by one, each its head and then its steps.
/// Encoder and decoder run this same code; `Side` is what differs:
///
///     frame()      what holds for all chains
///     coder()      an arithmetic encoder or decoder
///     head(i)      the true head of chain i
///     step(i, k)   the true step k of chain i
///     segments(i)  the true segments of chain i, if these are to be coded
///     begin(head)  a chain's head is complete
///     push(step)   so is a step of it
///     push_segment(s)  so are the steps of a segment of it
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
      const bool by_segments =
          head.steps > 0 && NumberModel::decide(side_.coder(), by_segments_,
                                                !side_.segments(i).empty());
      const Status done = by_segments ? code_segments(i, head, progress)
                                      : code_steps(i, head, progress);
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
      if (head.closed && at == head.origin &&
          ends(returns++, first - step, k + 1 == side_.head(i).steps)) {
        return {};
      }
      if (progress && k % 65536 == 65535 && !progress(i)) return cancelled();
    }
    // A closed chain has returned before, unless it has no steps.
    return head.closed && head.steps > 0 ? damaged(i) : Status();
  }

  /// Closed chains end at ends of segments only.
  Status code_segments(std::uint64_t i, const ChainHead& head,
                       const BlockProgress& progress) {
    const bool four = head.connectivity == Connectivity::four;
    Point at = head.origin;
    Step first = 0;
    Step last = 0;
    unsigned returns = 0;
    std::uint64_t open = head.steps;
    for (std::size_t k = 0; open > 0; ++k) {
      const auto truth = side_.segments(i);
      const DigitalSegment s = segments_.code(
          side_.coder(), k < truth.size() ? truth[k] : kNoSegment, last, four);
      if (side_.damaged() || segments_.outside() || s.n > open) {
        return damaged(i);
      }
      bool inside = false;
      at = end_of(s, at, inside);
      if (!inside) return damaged(i);
      heads_.visit(at);
      side_.push_segment(s);
      open -= s.n;
      left_ -= s.n;
      if (k == 0) first = s.s0;
      last = last_step(s);
      if (head.closed && at == head.origin &&
          ends(returns++, first - last, k + 1 == truth.size())) {
        return {};
      }
      if (progress && k % 1024 == 1023 && !progress(i)) return cancelled();
    }
    return head.closed ? damaged(i) : Status();
  }

  /// Of a closed chain that is at its origin again: whether it ends here.
  bool ends(unsigned returns, int turn, bool end) {
    return left_ == 0 || heads_.code_end(side_.coder(), returns,
                                         static_cast<unsigned>(turn), end);
  }

  /// What the decoder takes for the truth, which is not looked at.
  static constexpr DigitalSegment kNoSegment{0, 0, 2, 1, 2, 0};

  Side& side_;
  std::uint64_t count_;
  std::uint64_t left_;  ///< steps of the chains to come
  ChainHeadModel heads_;
  ChainModel model_;
  SegmentModel segments_;
  entropy::Counter by_segments_{kRarely, 4};  ///< nearly no chain is
  static constexpr std::uint16_t kRarely = 2048;
};

}  // namespace unstep::codec
