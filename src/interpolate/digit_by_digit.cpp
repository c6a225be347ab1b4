#include "interpolate/digit_by_digit.h"

#include <bit>
#include <cstdlib>

namespace unstep::interpolation {
namespace {

// value / 2^by, to nearest.
constexpr std::int64_t shifted(std::int64_t value, int by) {
  if (by == 0) return value;
  return (value + (std::int64_t{1} << (by - 1))) >> by;
}

constexpr std::int64_t constant(int i) {
  return kScaledAtan[static_cast<std::size_t>(i)];
}

}  // namespace

std::int64_t unit_start(int n) { return shifted(kInverseGain, kAngleBits - n); }

SinCos volder(std::int64_t phi, int n, std::int64_t start) {
  std::int64_t q = shifted(phi, kAngleBits - n);
  std::int64_t x = start;
  std::int64_t y = 0;
  for (int k = 0; k <= n; ++k) {
    const std::int64_t dx = shifted(y, k);
    const std::int64_t dy = shifted(x, k);
    const std::int64_t atan = shifted(constant(k), kAngleBits - n + k);
    if (q >= 0) {
      q -= atan;
      y -= dy;
      x += dx;
    } else {
      q += atan;
      y += dy;
      x -= dx;
    }
  }
  return {x, -y};  // the source's recurrence turns clockwise: y = -sin
}

SinCos meggitt(std::int64_t phi, int n, std::int64_t start, bool skip) {
  // Stage 1, i = 0..n-1: the signs.
  std::uint64_t negative = 0;
  std::int64_t q = shifted(phi, kAngleBits - n);
  for (int i = 0; i < n; ++i) {
    const std::int64_t atan = shifted(constant(i), kAngleBits - n);
    if (q < 0) negative |= std::uint64_t{1} << i;
    q = 2 * (q < 0 ? q + atan : q - atan);
  }
  // Stage 2, i = n..1.
  std::int64_t x = start;
  std::int64_t z = 0;
  for (int i = n; i >= 1; --i) {
    const bool minus = (negative >> (i - 1) & 1) != 0;
    const std::int64_t next_z = shifted(minus ? z - x : z + x, 1);
    if (!skip || i <= n / 2) {
      const int by = 2 * (i - 1);
      const std::int64_t correction = by > 62 ? 0 : shifted(z, by);
      x += minus ? correction : -correction;
    }
    z = next_z;
  }
  return {x, 2 * z};
}

std::int64_t angle_of(std::int64_t x, std::int64_t y) {
  if (x == 0 && y == 0) return 0;
  const bool back = x < 0;
  if (back) {
    x = -x;
    y = -y;
  }
  // 59 bits, so that the gain m sqrt(2) stays below 2^62.
  const auto size = static_cast<std::uint64_t>(x | std::abs(y));
  const int up = 59 - static_cast<int>(std::bit_width(size));
  x <<= up;
  y = y * (std::int64_t{1} << up);
  std::int64_t angle = 0;
  for (int k = 0; k < kMaxDigits; ++k) {
    const std::int64_t dx = shifted(y, k);
    const std::int64_t dy = shifted(x, k);
    const std::int64_t atan = shifted(constant(k), k);
    if (y >= 0) {
      x += dx;
      y -= dy;
      angle += atan;
    } else {
      x -= dx;
      y += dy;
      angle -= atan;
    }
  }
  if (!back) return angle;
  return angle > 0 ? angle - kPi : angle + kPi;
}

}  // namespace unstep::interpolation
