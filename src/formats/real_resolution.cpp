#include "formats/real_resolution.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace unstep {

/// Continued fractions of both ends, as long as they agree.
Rational simplest_rational(double low, double high) {
  constexpr double kMax = std::numeric_limits<std::uint32_t>::max();
  double n0 = 0, d0 = 1;  // the convergents
  double n1 = 1, d1 = 0;
  for (int depth = 0; depth < 40; ++depth) {
    const double whole = std::floor(low);
    const bool last = whole == low || whole + 1 <= high;
    const double part = last && whole != low ? whole + 1 : whole;
    const double n2 = part * n1 + n0;
    const double d2 = part * d1 + d0;
    if (!(n2 <= kMax && d2 <= kMax)) return {0, 1};
    n0 = n1, d0 = d1;
    n1 = n2, d1 = d2;
    if (last) break;
    const double next_low = 1 / (high - whole);
    high = 1 / (low - whole);
    low = next_low;
  }
  return {static_cast<std::uint32_t>(n1), static_cast<std::uint32_t>(d1)};
}

Rational density(double grid_units, double length, int decimals) {
  if (!(grid_units > 0 && length > 0)) return {0, 1};
  // Six significant digits or more were likely cut from a longer number.
  double error = length * 1e-12;
  const double half = 0.5 * std::pow(10.0, -decimals);
  if (decimals > 0 && half <= length * 1e-5) error = half;
  const double low = grid_units / (length + error);
  const double high = grid_units / (length - error);
  return simplest_rational(low, high);
}

}  // namespace unstep
