#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "codec/block_coder.h"
#include "codec/program_model.h"

namespace unstep::codec {

/// Coder 28, both sides: a program line by line. Encoder and decoder run this
/// same code; `Side` is what differs:
///
///     frame()       what holds for all lines
///     coder()       an arithmetic encoder or decoder
///     is_motion(i)  whether the true line i is one
///     motion(i)     then what it is
///     text(i)       otherwise its text
///     push(line)    a line is complete
///     damaged()     the payload cannot be right; give up
///
/// The decoder's answers to the questions are never looked at.
template <class Side>
class ProgramScan {
 public:
  /// `bytes`: of all lines, each with its end.
  ProgramScan(Side& side, std::uint64_t lines, std::uint64_t bytes)
      : side_(side), lines_(lines), left_(bytes), model_(lines) {}

  Status run(const BlockProgress& progress) {
    if (lines_ > 0 && !model_.code_frame(side_.coder(), side_.frame())) {
      return damaged(0);
    }
    std::string line;
    for (std::uint64_t i = 0; i < lines_; ++i) {
      if (progress && i % 4096 == 4095 && !progress(i)) {
        return Error{ErrorCode::cancelled, "cancelled"};
      }
      // Each line to come has its end.
      if (!code_line(i, line) || side_.damaged() || line.size() >= left_ ||
          left_ - line.size() - 1 < lines_ - i - 1) {
        return damaged(i);
      }
      left_ -= line.size() + 1;
      side_.push(line);
    }
    return left_ == 0 ? Status() : damaged(lines_);
  }

 private:
  static Error damaged(std::uint64_t i) {
    return {ErrorCode::corrupt,
            "program payload is damaged at line " + std::to_string(i + 1)};
  }

  bool code_line(std::uint64_t i, std::string& line) {
    if (!model_.code_kind(side_.coder(), side_.is_motion(i))) {
      return model_.code_text(side_.coder(), side_.text(i), left_, line);
    }
    ProgramLine motion = side_.motion(i);
    if (!model_.code_motion(side_.coder(), motion)) return false;
    line.clear();
    if (motion.motion < 0 && motion.words == 0) return false;
    append_line(line, motion);
    return true;
  }

  Side& side_;
  std::uint64_t lines_;
  std::uint64_t left_;  ///< bytes of the lines to come
  ProgramModel model_;
};

}  // namespace unstep::codec
