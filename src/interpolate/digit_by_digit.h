#pragma once

#include <array>
#include <cstdint>

#include "interpolate/ticks.h"

/// D3: digit by digit (Volder, Meggitt). Additions and shifts only.
///
/// Angles are int64 in units of 2^-60 rad; a full turn is 7.2e18 < 2^63.
/// Results are words of n binary digits after the point, 8 <= n <= 52.
namespace unstep::interpolation {

inline constexpr int kAngleBits = 60;

struct SinCos {
  std::int64_t cos = 0;
  std::int64_t sin = 0;
};

namespace detail {

inline constexpr int kSeriesBits = 110;

// atan(1 / denominator) in 2^-110 by its Taylor series; denominator >= 2.
constexpr Int128 atan_reciprocal(Int128 denominator) {
  Int128 power = (Int128{1} << kSeriesBits) / denominator;
  Int128 sum = 0;
  for (int i = 1; power != 0; i += 2) {
    sum += i % 4 == 1 ? power / i : -(power / i);
    power /= denominator;
    power /= denominator;
  }
  return sum;
}

// 2^i atan(2^-i) in 2^-60, rounded: the constants of Meggitt's form.
constexpr std::int64_t scaled_atan(int i) {
  const Int128 wide = i == 0 ? atan_reciprocal(2) + atan_reciprocal(3)
                             : atan_reciprocal(Int128{1} << i);
  const int drop = kSeriesBits - kAngleBits - i;
  if (drop <= 0) return std::int64_t{1} << kAngleBits;
  return static_cast<std::int64_t>((wide + (Int128{1} << (drop - 1))) >> drop);
}

}  // namespace detail

inline constexpr int kMaxDigits = 60;

/// 2^i atan(2^-i), i = 0..60.
inline constexpr auto kScaledAtan = [] {
  std::array<std::int64_t, kMaxDigits + 1> table{};
  for (int i = 0; i <= kMaxDigits; ++i)
    table[static_cast<std::size_t>(i)] = detail::scaled_atan(i);
  return table;
}();

inline constexpr std::int64_t kHalfPi = 2 * kScaledAtan[0];
inline constexpr std::int64_t kPi = 4 * kScaledAtan[0];

/// 1 / m, m = 1.6467602581..., in 2^-60.
inline constexpr std::int64_t kInverseGain = 700114967507363238;

/// kInverseGain as a word of n digits: the start that makes x = cos phi.
[[nodiscard]] std::int64_t unit_start(int n);

/// Volder's form, digits 0..n. `start` = r / m as a word of n digits gives
/// (r cos phi, r sin phi): 1 / m for the functions, R / m for an arc, dL / m
/// for the increments of a line. |phi| <= 1.743, |r| < 2^(61 - n).
///
/// Error: for r = 1, at most (2n + 4) 2^-n. The shifts round to nearest: each
/// of n + 1 digits adds at most 2^-1/2 2^-n to the vector, which grows m
/// times; the n + 1 constants and phi are 2^-(n+1) off each, and the angle
/// left over is at most 2^-n.
[[nodiscard]] SinCos volder(std::int64_t phi, int n, std::int64_t start);

/// Meggitt's form (z_i = 2^i y_i). Same arguments. With `skip` the correction
/// of X is left out for i > n / 2, where it is below the word's grid (block 11
/// of the source's flow chart).
///
/// Error: for r = 1, at most (n / 2 + 10) 2^-n, skip or not: the residue is
/// doubled, so constants lose nothing (2^-n in all), the angle left over is
/// at most 2^-(n-1), Z is halved with every digit, so its roundings make 2
/// 2^-n, X is rounded n / 2 times, the skipped terms make 4 2^-n at most.
[[nodiscard]] SinCos meggitt(std::int64_t phi, int n, std::int64_t start,
                             bool skip = true);

/// The angle of (x, y), -pi..pi, by Volder's vectoring: the "one constant" of
/// the line and the start angle of an arc. Within 2^-53 rad. 0 for (0, 0).
/// REQUIRES: |x|, |y| <= 2^33.
[[nodiscard]] std::int64_t angle_of(std::int64_t x, std::int64_t y);

}  // namespace unstep::interpolation
