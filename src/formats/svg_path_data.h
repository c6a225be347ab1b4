#pragma once

#include <cstdint>
#include <string>

#include "formats/format_writer.h"

namespace unstep {

/// The d attribute of an SVG path, in few characters: relative moves, h and v,
/// no command letter twice, no separator where the grammar needs none. Numbers
/// are path units with the point moved by `decimals`.
class SvgPathData {
 public:
  /// `limit`: an arc may deviate by that many path units for a short radius.
  SvgPathData(int decimals, double limit)
      : decimals_(decimals), limit_(limit) {}

  /// Starts a new attribute: the first move is from (0, 0).
  void restart();
  void add(const Outline& outline, std::string& text);

 private:
  void command(char letter, std::string& text);
  void number(std::int64_t value, std::string& text);
  void raw_number(const std::string& digits, std::string& text);
  void flag(bool value, std::string& text);
  void line(WidePoint move, std::string& text);
  void arc(const Piece& piece, std::string& text);
  void half_circle(WidePoint move, bool ascending, std::string& text);
  void find_radius(const Piece& piece);

  int decimals_;
  double limit_;
  char last_ = 0;          ///< the command that a number would continue
  bool separate_ = false;  ///< a digit came last
  bool pointed_ = false;   ///< and its number has a point
  WidePoint at_;
  std::string digits_;
};

}  // namespace unstep
