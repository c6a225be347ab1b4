#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

/// Products of two 128-bit numbers, for comparisons of squared roots.
namespace unstep {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// 256 bits; ordered as a number.
struct WideProduct {
  UInt128 high = 0;
  UInt128 low = 0;
  friend bool operator==(const WideProduct&, const WideProduct&) = default;
  friend auto operator<=>(const WideProduct&, const WideProduct&) = default;
};

/// a * b; cannot overflow.
[[nodiscard]] constexpr WideProduct wide_product(UInt128 a, UInt128 b) {
  constexpr UInt128 kMask = (UInt128{1} << 64) - 1;
  const UInt128 a0 = a & kMask;
  const UInt128 a1 = a >> 64;
  const UInt128 b0 = b & kMask;
  const UInt128 b1 = b >> 64;
  const UInt128 low = a0 * b0;
  // Three terms below 2^64 and one below 2^128 - 2^65 + 1: no carry is lost.
  const UInt128 middle = a1 * b0 + (low >> 64);
  const UInt128 other = a0 * b1 + (middle & kMask);
  return {a1 * b1 + (middle >> 64) + (other >> 64),
          (other << 64) | (low & kMask)};
}

/// 384 bits, most significant first; ordered as a number.
struct TripleProduct {
  UInt128 high = 0;
  UInt128 middle = 0;
  UInt128 low = 0;
  friend bool operator==(const TripleProduct&, const TripleProduct&) = default;
  friend auto operator<=>(const TripleProduct&, const TripleProduct&) = default;
};

/// a * b * c; cannot overflow.
[[nodiscard]] constexpr TripleProduct triple_product(UInt128 a, UInt128 b,
                                                     UInt128 c) {
  const WideProduct ab = wide_product(a, b);
  const WideProduct low = wide_product(ab.low, c);
  WideProduct high = wide_product(ab.high, c);
  const UInt128 middle = high.low + low.high;
  if (middle < high.low) ++high.high;
  return {high.high, middle, low.low};
}

[[nodiscard]] constexpr UInt128 magnitude_of(Int128 value) {
  return value < 0 ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
}

/// floor(sqrt(square)).
[[nodiscard]] constexpr UInt128 floor_root(const WideProduct& square) {
  UInt128 root = 0;
  for (UInt128 bit = UInt128{1} << 127; bit != 0; bit >>= 1)
    if (wide_product(root | bit, root | bit) <= square) root |= bit;
  return root;
}

/// floor(sqrt(square)). REQUIRES: square < 2^126. The estimate has 64 bits and
/// so is at most one off either way.
[[nodiscard]] inline std::uint64_t floor_root(UInt128 square) {
  auto root = static_cast<UInt128>(std::sqrt(static_cast<long double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return static_cast<std::uint64_t>(root);
}

/// d <= sqrt(a) + sqrt(b). REQUIRES: a, b < 2^125.
[[nodiscard]] constexpr bool at_most_sum_of_roots(UInt128 d, UInt128 a,
                                                  UInt128 b) {
  if (d >= UInt128{1} << 64) return false;  // the roots are below 2^62.5
  const UInt128 square = d * d;
  if (square <= a + b) return true;
  const UInt128 rest = square - a - b;
  // rest <= 2 sqrt(a b); 4 a < 2^127.
  return wide_product(rest, rest) <= wide_product(4 * a, b);
}

/// p - sqrt(a) <= q - sqrt(b). REQUIRES: 0 <= a, b < 2^124, |p|, |q| < 2^126.
[[nodiscard]] constexpr bool low_end_at_most(Int128 p, UInt128 a, Int128 q,
                                             UInt128 b) {
  const UInt128 d = magnitude_of(p - q);
  if (d >= UInt128{1} << 62) return p <= q;  // more than either root
  const UInt128 square = d * d;              // < 2^124
  if (p >= q) {                              // d + sqrt(b) <= sqrt(a)
    if (square + b > a) return false;
    const UInt128 rest = a - b - square;
    return wide_product(4 * square, b) <= wide_product(rest, rest);
  }
  // sqrt(b) - d <= sqrt(a)
  if (b <= a || b <= square || b + square <= a) return true;
  const UInt128 rest = b + square - a;
  return wide_product(rest, rest) <= wide_product(4 * square, b);
}

}  // namespace unstep
