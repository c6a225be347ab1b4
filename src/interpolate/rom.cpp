#include "interpolate/rom.h"

#include <cstdlib>

namespace unstep::interpolation {
namespace {

// The finest table, step 2^-10; coarser ones take every 2^k-th node. Two nodes
// past pi / 2 serve the corrections down to a step of 2^-4: 27/16 rad.
constexpr int kFinestBits = kMaxRomBits;
constexpr int kNodes = 1729;
constexpr Int128 kOne = Int128{1} << kAngleBits;

// Taylor series in 2^-90; x = i / 1024 < 1.69, terms fall below 2^-90
// before k = 40.
constexpr std::int64_t taylor(int i, bool sine) {
  constexpr int kBits = 90;
  const Int128 one = Int128{1} << kBits;
  Int128 term = sine ? one / 1024 * i : one;
  Int128 sum = term;
  for (int k = sine ? 2 : 1; k < 40; k += 2) {
    // term *= -x^2 / (k (k + 1)), x^2 = i^2 / 2^20.
    term = -(term / (Int128{1} << 20) * (Int128{i} * i)) / (k * (k + 1));
    sum += term;
  }
  return static_cast<std::int64_t>(
      (sum + (Int128{1} << (kBits - kAngleBits - 1))) >> (kBits - kAngleBits));
}

struct Tables {
  std::array<std::int64_t, kNodes> sin{};
  std::array<std::int64_t, kNodes> cos{};
  std::array<std::int64_t, kNodes - 1> sin_difference{};
  std::array<std::int64_t, kNodes - 1> cos_difference{};
};

constexpr Tables kTables = [] {
  Tables t;
  for (int i = 0; i < kNodes; ++i) {
    t.sin[static_cast<std::size_t>(i)] = taylor(i, true);
    t.cos[static_cast<std::size_t>(i)] = taylor(i, false);
  }
  for (std::size_t i = 0; i + 1 < kNodes; ++i) {
    t.sin_difference[i] = t.sin[i + 1] - t.sin[i];
    t.cos_difference[i] = t.cos[i + 1] - t.cos[i];
  }
  return t;
}();

constexpr std::int64_t multiply(std::int64_t a, std::int64_t b) {
  const Int128 product = Int128{a} * b;
  return static_cast<std::int64_t>((product + kOne / 2) >> kAngleBits);
}

// Nodes f0..f3 at -1, 0, 1, 2 steps; t in [0, 1) of the middle step.
std::int64_t cubic(std::int64_t f0, std::int64_t f1, std::int64_t f2,
                   std::int64_t f3, std::int64_t t) {
  const std::int64_t d1 = f1 - f0;
  const std::int64_t d2 = f2 - 2 * f1 + f0;
  const std::int64_t d3 = f3 - 3 * (f2 - f1) - f0;
  const auto one = static_cast<std::int64_t>(kOne);
  // Newton from node -1 with u = t + 1: f0 + u d1 + u(u-1)/2 d2 +
  // u(u-1)(u-2)/6 d3.
  const std::int64_t second = multiply(t + one, t) / 2;
  const std::int64_t third = multiply(multiply(t + one, t), t - one) / 6;
  return f1 + multiply(t, d1) + multiply(second, d2) + multiply(third, d3);
}

std::int64_t parabola(std::int64_t f0, std::int64_t f1, std::int64_t f2,
                      std::int64_t t) {
  const auto one = static_cast<std::int64_t>(kOne);
  return f0 + multiply(t, f1 - f0) +
         multiply(multiply(t, t - one) / 2, f2 - 2 * f1 + f0);
}

}  // namespace

Rom::Node Rom::node(std::int64_t index) {
  const auto at = static_cast<std::size_t>(index);
  if (form_ == RomForm::values) return {kTables.cos[at], kTables.sin[at]};
  if (std::abs(index - last_) > index) {
    last_ = 0;
    sum_ = {std::int64_t{1} << kAngleBits, 0};
  } else if (std::abs(index - last_) > kNodes - 1 - index) {
    last_ = kNodes - 1;
    sum_ = {kTables.cos.back(), kTables.sin.back()};
  }
  for (; last_ < index; ++last_) {
    sum_.cos += kTables.cos_difference[static_cast<std::size_t>(last_)];
    sum_.sin += kTables.sin_difference[static_cast<std::size_t>(last_)];
  }
  for (; last_ > index; --last_) {
    sum_.cos -= kTables.cos_difference[static_cast<std::size_t>(last_ - 1)];
    sum_.sin -= kTables.sin_difference[static_cast<std::size_t>(last_ - 1)];
  }
  return sum_;
}

SinCos Rom::at(std::int64_t phi, int n) {
  const int low = kAngleBits - bits_;
  const std::int64_t stride = std::int64_t{1} << (kFinestBits - bits_);
  const std::int64_t index = (phi >> low) * stride;
  // The low bits of the angle, as a fraction of the table step.
  const std::int64_t t = (phi & ((std::int64_t{1} << low) - 1)) << bits_;
  // The node before 0 by symmetry.
  Node before = index > 0 ? node(index - stride) : node(stride);
  if (index == 0) before.sin = -before.sin;
  const Node f1 = node(index);
  const Node f2 = node(index + stride);
  SinCos wide;
  switch (correction_) {
    case RomCorrection::linear:
      wide.cos = f1.cos + multiply(t, f2.cos - f1.cos);
      wide.sin = f1.sin + multiply(t, f2.sin - f1.sin);
      break;
    case RomCorrection::parabolic: {
      const Node f3 = node(index + 2 * stride);
      wide.cos = parabola(f1.cos, f2.cos, f3.cos, t);
      wide.sin = parabola(f1.sin, f2.sin, f3.sin, t);
      break;
    }
    case RomCorrection::cubic: {
      const Node f3 = node(index + 2 * stride);
      wide.cos = cubic(before.cos, f1.cos, f2.cos, f3.cos, t);
      wide.sin = cubic(before.sin, f1.sin, f2.sin, f3.sin, t);
      break;
    }
  }
  const int drop = kAngleBits - n;
  const std::int64_t half = std::int64_t{1} << (drop - 1);
  return {(wide.cos + half) >> drop, (wide.sin + half) >> drop};
}

}  // namespace unstep::interpolation
