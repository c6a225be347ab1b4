#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "unstep/result.h"

namespace unstep {

/// Instructions of an HPGL file: a name of two letters and numbers.
class HpglScanner {
 public:
  explicit HpglScanner(std::string_view text) : text_(text) {}

  /// The next name in capitals, "" at the end; its numbers in `values`. Labels
  /// (LB) and device control (escape sequences) are passed
  /// over; the text of PE is in encoded(). corrupt, naming the byte, for what
  /// is no instruction.
  Result<std::string_view> next(std::vector<double>& values);

  /// Where the name of the last instruction is.
  [[nodiscard]] std::size_t instruction_offset() const { return begin_; }
  /// What follows a PE, without its semicolon.
  [[nodiscard]] std::string_view encoded() const { return encoded_; }
  [[nodiscard]] bool any() const { return any_; }

 private:
  void skip_escape();
  Status read_values(std::vector<double>& values);

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  bool any_ = false;
  char label_end_ = '\x03';
  std::string name_;
  std::string_view encoded_;
};

}  // namespace unstep
