#pragma once

#include <optional>
#include <string_view>

namespace unstep {

/// Walks the text of PE, the encoded lines of HPGL/2 (PCL 5 Printer Language
/// Technical Reference, chapter 20): flags and numbers of base 64 or 32, the
/// lowest digit first, the last one marked, the lowest bit the sign.
class HpglEncodedLines {
 public:
  struct Move {
    double x = 0;
    double y = 0;
    bool absolute = false;
    bool up = false;
  };

  explicit HpglEncodedLines(std::string_view text) : text_(text) {}

  /// The next move; nothing at the end or at a fault.
  std::optional<Move> next();
  [[nodiscard]] bool faulty() const { return faulty_; }

 private:
  std::optional<double> number();

  std::string_view text_;
  bool seven_bits_ = false;
  double unit_ = 1;  ///< of coordinates: 2^-(fractional bits)
  bool faulty_ = false;
};

}  // namespace unstep
