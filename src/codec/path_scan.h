#pragma once

#include <cstdint>
#include <string>

#include "codec/block_coder.h"
#include "codec/path_coder.h"
#include "codec/path_head_model.h"
#include "codec/path_model.h"
#include "codec/path_warm_start.h"

namespace unstep::codec {

/// Coder 24, both sides: paths one by one, each its head and then its
/// elements. Encoder and decoder run this same code; `Side` is what differs:
///
///     frame()       what holds for all paths
///     coder()       an arithmetic encoder or decoder
///     head(i)       the true head of path i
///     element(i, k) the true element k of path i
///     begin(head)   a path's head is complete
///     push(element) so is an element of it
///     end()         so are all of them
///     damaged()     the payload cannot be right; give up
///
/// The decoder's answers to the questions are never looked at.
template <class Side>
class PathScan {
 public:
  PathScan(Side& side, std::uint64_t count, std::uint64_t elements,
           const path_warm::Table& start = path_warm::kTable)
      : side_(side), count_(count), left_(elements) {
    path_warm::apply(start, model_.vectors());
  }

  [[nodiscard]] PathModel& model() { return model_; }

  Status run(const BlockProgress& progress) {
    if (count_ > 0) model_.code_frame(side_.coder(), side_.frame());
    for (std::uint64_t i = 0; i < count_; ++i) {
      if (progress && i % 64 == 63 && !progress(i)) return cancelled();
      const bool last = i + 1 == count_;
      const PathHead head =
          heads_.code(side_.coder(), side_.head(i), model_, left_, last);
      if (side_.damaged() || heads_.outside() || head.elements > left_) {
        return damaged(i);
      }
      left_ -= head.elements;
      side_.begin(head);
      model_.begin(head);
      for (std::uint64_t k = 0; k < head.elements; ++k) {
        if (!code_element(i, k)) return damaged(i);
        if (progress && k % 4096 == 4095 && !progress(i)) return cancelled();
      }
      model_.end();
      side_.end();
    }
    // Of no paths there are no elements.
    return left_ == 0 ? Status() : damaged(0);
  }

 private:
  static Error cancelled() { return {ErrorCode::cancelled, "cancelled"}; }
  static Error damaged(std::uint64_t i) {
    return {ErrorCode::corrupt,
            "path payload is damaged at path " + std::to_string(i + 1)};
  }

  bool code_element(std::uint64_t i, std::uint64_t k) {
    Path::Element element = side_.element(i, k);
    if (side_.damaged() || !model_.code(side_.coder(), element)) return false;
    side_.push(element);
    return true;
  }

  Side& side_;
  std::uint64_t count_;
  std::uint64_t left_;  ///< elements of the paths to come
  PathHeadModel heads_;
  PathModel model_;
};

}  // namespace unstep::codec
