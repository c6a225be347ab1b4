#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "formats/text_scanner.h"

/// Words and numbers of value change dumps.
namespace unstep::vcd {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' ||
         c == '\v';
}

/// A name or code as an error message may show it.
inline std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 60;
  std::string out(text.substr(0, kMost));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + out + (text.size() > kMost ? "...'" : "'");
}

/// "[7]" or "[7:0]". The last number is the index of the rightmost bit.
struct Range {
  std::int64_t left = 0;
  std::int64_t right = 0;
};

inline std::optional<Range> parse_range(std::string_view text) {
  if (text.size() < 3 || text.front() != '[' || text.back() != ']') {
    return std::nullopt;
  }
  text = text.substr(1, text.size() - 2);
  const std::size_t colon = text.find(':');
  Range range;
  if (!parse_whole(text.substr(0, colon), range.left)) return std::nullopt;
  range.right = range.left;
  if (colon != std::string_view::npos &&
      !parse_whole(text.substr(colon + 1), range.right)) {
    return std::nullopt;
  }
  constexpr std::int64_t kMost = std::int64_t{1} << 32;
  if (std::max(std::abs(range.left), std::abs(range.right)) > kMost) {
    return std::nullopt;
  }
  return range;
}

}  // namespace unstep::vcd
