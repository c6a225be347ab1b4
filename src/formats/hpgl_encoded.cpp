#include "formats/hpgl_encoded.h"

#include <cmath>
#include <cstdint>

namespace unstep {

std::optional<double> HpglEncodedLines::number() {
  constexpr int kFirst = 63;
  const int base = seven_bits_ ? 32 : 64;
  const int last = seven_bits_ ? 95 : 191;
  std::uint64_t value = 0;
  // Nine digits of 64 are beyond every coordinate.
  for (int shift = 0; shift < 54 && !text_.empty();
       shift += seven_bits_ ? 5 : 6) {
    int digit = static_cast<unsigned char>(text_.front());
    text_.remove_prefix(1);
    const bool ends = digit >= last;
    digit -= ends ? last : kFirst;
    if (digit < 0 || digit >= base) break;
    value |= static_cast<std::uint64_t>(digit) << shift;
    if (!ends) continue;
    const auto size = static_cast<double>(value >> 1);
    return (value & 1) != 0 ? -size : size;
  }
  faulty_ = true;
  return std::nullopt;
}

std::optional<HpglEncodedLines::Move> HpglEncodedLines::next() {
  Move move;
  while (!text_.empty()) {
    const char c = text_.front();
    if (c == '<' || c == '=' || c == '7' || c == ':' || c == '>') {
      text_.remove_prefix(1);
      move.up = move.up || c == '<';
      move.absolute = move.absolute || c == '=';
      seven_bits_ = seven_bits_ || c == '7';
      if (c == ':' || c == '>') {
        const std::optional<double> value = number();
        if (!value) return std::nullopt;
        if (c == '>') unit_ = std::exp2(-std::fmax(0, std::fmin(*value, 30)));
      }
      continue;
    }
    // Line ends may stand anywhere.
    if (static_cast<unsigned char>(c) <= ' ') {
      text_.remove_prefix(1);
      continue;
    }
    const std::optional<double> x = number();
    const std::optional<double> y = x ? number() : std::nullopt;
    if (!y) return std::nullopt;
    move.x = *x * unit_;
    move.y = *y * unit_;
    return move;
  }
  return std::nullopt;
}

}  // namespace unstep
