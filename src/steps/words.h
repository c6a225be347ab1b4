#pragma once

#include <array>
#include <cstdint>

#include "unstep/step_stream.h"

namespace unstep::steps {

/// The word of a Freeman code, and back; 8 for a word that is none.
inline constexpr std::array<StepWord, 8> kWords = [] {
  std::array<StepWord, 8> words{};
  for (std::size_t code = 0; code < 8; ++code) {
    const Point d = step_delta(static_cast<Step>(code));
    const auto bits = [](std::int32_t way) {
      return way == 0 ? 0U : way > 0 ? 1U : 3U;
    };
    words[code] = static_cast<StepWord>(bits(d.x) | bits(d.y) << 2);
  }
  return words;
}();

inline constexpr std::array<std::uint8_t, 16> kCodes = [] {
  std::array<std::uint8_t, 16> codes{};
  codes.fill(8);
  for (std::size_t code = 0; code < 8; ++code) {
    codes[kWords[code]] = static_cast<std::uint8_t>(code);
  }
  return codes;
}();

}  // namespace unstep::steps
