#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

/// What the models of turns share: how contexts are made of numbers and how
/// much an old counter is trusted.
namespace unstep::codec {

/// 2^64 / golden ratio, the multiplier of all hashes.
inline constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;

/// Two numbers to one, for hashing.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  return a * kGolden ^ (b * 0xc2b2ae3d27d4eb4fULL + 0x165667b19e3779f9ULL) ^
         (a >> 29);
}

/// Sign and magnitude, two levels an octave: 0..most, and as many from
/// most + 1 on for negative values.
[[nodiscard]] inline unsigned signed_level(std::int64_t value, unsigned most) {
  const auto size = static_cast<std::uint64_t>(value < 0 ? -value : value);
  const auto octave = static_cast<unsigned>(std::bit_width(size));
  const unsigned level =
      octave < 2
          ? octave
          : octave * 2 - 2 + static_cast<unsigned>(size >> (octave - 2) & 1);
  return std::min(level, most) + (value < 0 ? most + 1 : 0U);
}

/// An area, 0..31.
[[nodiscard]] inline unsigned quantise_area(std::int64_t area) {
  return signed_level(area, 15);
}

/// The weight of (p - 1/2) as a second input of each counter: it grows with
/// the age n, up to 30 observations; the product is at most 32768 * 1530 >> 16.
constexpr std::array<std::int16_t, 256> make_trust() {
  std::array<std::int16_t, 256> trust{};
  for (std::size_t n = 0; n < trust.size(); ++n) {
    trust[n] = static_cast<std::int16_t>(51 * std::min<std::size_t>(n, 30));
  }
  return trust;
}

inline constexpr auto kTrust = make_trust();

}  // namespace unstep::codec
